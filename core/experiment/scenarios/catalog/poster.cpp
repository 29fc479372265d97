// SPDX-License-Identifier: GPL-3.0-or-later
// S13: posters of the ball's own color behind it.
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/scenario_paths.h"
#include "core/experiment/scenarios/targets/hidden_share.h"
#include "core/simulation/scene/scene.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <utility>

namespace dewpoint::experiment::scenarios {
namespace {

using simulation::StageBody;

/// Posters that are tried behind one path; chosen.
constexpr int kPostersPerPath = 400;

/// A flat board of the target's color that stands behind the path of the ball as a camera sees it
/// and faces the camera, up to 20 degrees off.
StageBody drawPoster(ScenarioDraft& draft, std::size_t camera, const Eigen::Vector3d& center) {
  constexpr double kTilt = 20.0 * std::numbers::pi / 180.0; // radians
  RandomDraws& draws = draft.draws;
  const Eigen::Vector3d sight = (center - draft.rig[camera].center()).normalized();
  const Eigen::Vector3d right = sight.cross(Eigen::Vector3d::UnitZ()).normalized();
  const Eigen::Vector3d up = right.cross(sight);
  const double behind = draws.drawUniform(0.15, 0.45); // meters
  const double aside = draws.drawUniform(-0.1, 0.1);
  const double above = draws.drawUniform(-0.05, 0.1);
  const Eigen::Vector3d position = center + behind * sight + aside * right + above * up;
  const Eigen::AngleAxisd tilt(draws.drawUniform(-kTilt, kTilt), draws.drawDirection());
  StageBody poster;
  poster.isBox = true;
  poster.halfSize = {draws.drawUniform(0.06, 0.14), draws.drawUniform(0.06, 0.14), 0.002};
  poster.axes.row(0) = tilt * right;
  poster.axes.row(1) = tilt * up;
  poster.axes.row(2) = tilt * sight;
  poster.path = [position](double) { return position; };
  return poster;
}

/// The poster hides the ball from no camera and does not touch it. Where it is behind the ball its
/// center is farther too, as the painter's order is that of the centers.
bool staysBehind(const ScenarioDraft& draft, const LissajousPath& path, const StageBody& poster) {
  const Eigen::Vector3d normal = poster.axes.row(2);
  for (std::int64_t frame = 0; frame < draft.frameCount; frame += kFractionCheckInterval) {
    const Eigen::Vector3d ball = path(draft.timeOf(frame));
    if ((poster.path(0.0) - ball).dot(normal) < 1.5 * kBallRadius) {
      return false;
    }
    for (const Camera& camera : draft.rig) {
      const Eigen::Vector3d eye = camera.center();
      const bool farther = (poster.path(0.0) - eye).norm() > (ball - eye).norm();
      const bool beside = overlappedFraction(eye, ball, kBallRadius, {boxPart(poster)}) == 0.0;
      if (!(farther || beside) || hiddenShare(eye, ball, kBallRadius, {boxPart(poster)}) > 0.0) {
        return false;
      }
    }
  }
  return true;
}

/// How often, of the frames, a camera has the poster behind all of the ball, and behind less than
/// half of it.
struct Backing {
  double whole = 0.0;
  double little = 0.0;
  double most = 0.0; ///< the greatest share of the disc in any frame
};

Backing backingOf(const ScenarioDraft& draft, std::size_t camera, const LissajousPath& path,
                  const StageBody& poster) {
  constexpr double kWhole = 0.99; // of the disc: but for one of its points, see kDiskPoints
  Backing backing;
  int frames = 0;
  for (std::int64_t frame = 0; frame < draft.frameCount;
       frame += kFractionCheckInterval, ++frames) {
    const double share = overlappedFraction(draft.rig[camera].center(), path(draft.timeOf(frame)),
                                            kBallRadius, {boxPart(poster)});
    backing.whole += share > kWhole ? 1.0 : 0.0;
    backing.little += share < 0.5 ? 1.0 : 0.0;
    backing.most = std::max(backing.most, share);
  }
  backing.whole /= frames;
  backing.little /= frames;
  return backing;
}

/// The ball crosses the poster's border: it is before it for a third of the time at least, and
/// mostly beside it for a tenth.
bool isCrossed(const Backing& backing) {
  return backing.whole >= 1.0 / 3.0 && backing.little >= 0.1;
}

bool addPoster(ScenarioDraft& draft, std::size_t camera, const LissajousPath& path, bool alone) {
  for (int i = 0; i < kPostersPerPath; ++i) {
    StageBody poster = drawPoster(draft, camera, path.center);
    bool good =
        staysBehind(draft, path, poster) && isCrossed(backingOf(draft, camera, path, poster));
    for (std::size_t other = 0; good && alone && other < draft.rig.size(); ++other) {
      good = other == camera || backingOf(draft, other, path, poster).most == 0.0;
    }
    if (good) {
      poster.name = fmt::format("poster {}", camera + 1);
      draft.stage.bodies.push_back(std::move(poster));
      return true;
    }
  }
  return false;
}

bool beforePosters(ScenarioDraft& draft, bool everyCamera) {
  for (int layout = 0; layout < kMaxLayoutAttempts; ++layout) {
    draft.stage.bodies.clear();
    draft.targets.clear();
    draft.frameCount = kDefaultFrameCount;
    const auto path = randomDeskPath(draft, false);
    if (!path) {
      return false;
    }
    addTarget(draft, *path);
    const auto last = static_cast<int>(draft.rig.size()) - 1;
    const auto chosen = static_cast<std::size_t>(draft.draws.drawInteger(0, last));
    bool placed = true;
    for (std::size_t camera = 0; camera < draft.rig.size(); ++camera) {
      const bool wanted = everyCamera || camera == chosen;
      placed = placed && (!wanted || addPoster(draft, camera, *path, !everyCamera));
    }
    if (placed) {
      startNearTruth(draft);
      return true;
    }
  }
  return false;
}

} // namespace

std::vector<ScenarioRecipe> posterScenarios() {
  ScenarioRecipe one{"S13-one-camera",
                     "A poster of the ball's color is behind it in one camera; the ball crosses "
                     "its border.",
                     demoRig()};
  one.complete = [](ScenarioDraft& draft) { return beforePosters(draft, false); };
  ScenarioRecipe both{"S13-both-cameras", "The same with a poster for each camera.", demoRig()};
  both.complete = [](ScenarioDraft& draft) { return beforePosters(draft, true); };
  return {one, both};
}

} // namespace dewpoint::experiment::scenarios
