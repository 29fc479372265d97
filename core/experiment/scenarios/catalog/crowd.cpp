// SPDX-License-Identifier: GPL-3.0-or-later
// S19: the target among identical balls that fly freely, touch and cover each other.
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/scenario_paths.h"
#include "core/experiment/scenarios/targets/crowd_motion.h"
#include "core/simulation/scene/rigs.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace dewpoint::experiment::scenarios {
namespace {

/// Centers at the start are farther apart than this, radii; chosen: they do not quite touch.
constexpr double kApartAtStart = 2.2;
/// Speeds at the start, m/s: those of the smooth path.
constexpr double kSlowestFlight = 0.1;
constexpr double kFastestFlight = 0.3;
/// Half size of the box in which the search starts, and how far its center is off, meters; chosen:
/// tighter than elsewhere, as no other ball may be in it.
constexpr double kStartHalf = 0.05;
constexpr double kStartOff = 0.02;

using Region = Eigen::AlignedBox3d;

/// Whether all images show balls whole in all corners of a region.
bool showsAll(const ScenarioDraft& draft, const Region& region) {
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d position = region.corner(static_cast<Region::CornerType>(corner));
    if (!isFullyVisible(draft.stage, position, draft.ballRadius())) {
      return false;
    }
  }
  return true;
}

/// Where the balls' centers fly, meters. Every camera of the ring sees all of it; of other cameras
/// it is made as small as they need. Nothing when it would be too small.
std::optional<Region> crowdRegion(const ScenarioDraft& draft) {
  constexpr double kStep = 0.9;  // of its size; chosen
  constexpr double kLeast = 0.3; // of its size; chosen: 11 x 11 x 7 cm
  const Region whole{Eigen::Vector3d(0.32, 0.32, 0.06), Eigen::Vector3d(0.68, 0.68, 0.28)};
  if (draft.grade != Grade::Wild) {
    return whole;
  }
  for (double scale = draft.pathScale; scale >= kLeast; scale *= kStep) {
    const Eigen::Vector3d half = 0.5 * scale * whole.sizes();
    const Region region{whole.center() - half, whole.center() + half};
    if (showsAll(draft, region)) {
      return region;
    }
  }
  return std::nullopt;
}

Eigen::Vector3d drawPosition(const Region& region, RandomDraws& draws) {
  return draws.drawPointInBox(region.min(), region.max());
}

bool isApart(const ScenarioDraft& draft, const CrowdStart& crowd, const Eigen::Vector3d& position) {
  return std::ranges::all_of(crowd.positions, [&](const Eigen::Vector3d& other) {
    return (other - position).norm() > kApartAtStart * draft.ballRadius();
  });
}

void addFlyer(CrowdStart& crowd, const Eigen::Vector3d& position, RandomDraws& draws) {
  crowd.positions.push_back(position);
  const double speed = draws.drawUniform(kSlowestFlight, kFastestFlight);
  crowd.velocities.push_back(speed * draws.drawDirection());
}

/// The first body is the target, the others are its like.
void addBodies(ScenarioDraft& draft, const CrowdStart& crowd, const Region& region) {
  const auto motion = std::make_shared<const CrowdMotion>(crowd, region, draft.ballRadius(),
                                                          draft.timeOf(draft.frameCount) +
                                                              draft.stage.exposureSeconds);
  addTarget(draft, pathOf(motion, 0));
  for (std::size_t ball = 1; ball < crowd.positions.size(); ++ball) {
    simulation::StageBody& body = draft.stage.bodies.emplace_back();
    body.name = fmt::format("distractor {}", ball);
    body.radius = kBallRadius;
    body.path = pathOf(motion, ball);
  }
}

/// Only the target is in the box where the search starts, with all of its body.
bool crowd(ScenarioDraft& draft, std::size_t distractors) {
  draft.frameCount = kDefaultFrameCount;
  const auto region = crowdRegion(draft);
  if (!region) {
    return false;
  }
  RandomDraws& draws = draft.draws;
  CrowdStart balls;
  addFlyer(balls, drawPosition(*region, draws), draws);
  const Eigen::Vector3d off = draws.drawPointInBox(Eigen::Vector3d::Constant(-kStartOff),
                                                   Eigen::Vector3d::Constant(kStartOff));
  draft.startCenter = balls.positions.front() + off;
  draft.startHalfSize = Eigen::Vector3d::Constant(kStartHalf);
  const Eigen::Vector3d around = draft.startHalfSize + Eigen::Vector3d::Constant(kBallRadius);
  const Eigen::AlignedBox3d kept(draft.startCenter - around, draft.startCenter + around);
  for (int i = 0; i < kMaxDrawAttempts && balls.positions.size() <= distractors; ++i) {
    const Eigen::Vector3d position = drawPosition(*region, draws);
    if (isApart(draft, balls, position) && !kept.contains(position)) {
      addFlyer(balls, position, draws);
    }
  }
  if (balls.positions.size() <= distractors) {
    return false;
  }
  addBodies(draft, balls, *region);
  return true;
}

/// Two balls, and a search that starts in the middle between them: nothing tells which is meant.
bool evenStart(ScenarioDraft& draft) {
  /// Around the two balls' centers, meters; as startAroundAllTargets().
  constexpr double kAround = 0.05;
  draft.frameCount = kDefaultFrameCount;
  const auto region = crowdRegion(draft);
  if (!region) {
    return false;
  }
  RandomDraws& draws = draft.draws;
  CrowdStart balls;
  addFlyer(balls, drawPosition(*region, draws), draws);
  for (int i = 0; i < kMaxDrawAttempts && balls.positions.size() < 2; ++i) {
    const Eigen::Vector3d position = drawPosition(*region, draws);
    if (isApart(draft, balls, position)) {
      addFlyer(balls, position, draws);
    }
  }
  if (balls.positions.size() < 2) {
    return false;
  }
  addBodies(draft, balls, *region);
  const Eigen::Vector3d& one = balls.positions[0];
  const Eigen::Vector3d& other = balls.positions[1];
  draft.startCenter = 0.5 * (one + other);
  draft.startHalfSize = 0.5 * (one - other).cwiseAbs() + Eigen::Vector3d::Constant(kAround);
  draft.equalCandidateCount = 2;
  return true;
}

} // namespace

std::vector<ScenarioRecipe> crowdScenarios() {
  const auto recipe = [](std::size_t distractors, int cameras) {
    ScenarioRecipe result{
        fmt::format("S19-crowd-{}{}", distractors, cameras == 4 ? "-four-cameras" : ""),
        fmt::format("{} identical balls fly freely with the target, touch and cover each other; {} "
                    "cameras.",
                    distractors, cameras),
        deskRingRig(cameras)};
    result.complete = [distractors](ScenarioDraft& draft) { return crowd(draft, distractors); };
    return result;
  };
  ScenarioRecipe even{"S19-even-start",
                      "Two identical balls; the search starts halfway between them, so that each "
                      "is the target with a probability of one half.",
                      deskRingRig(2)};
  even.complete = evenStart;
  return {recipe(5, 2), recipe(8, 2), recipe(12, 2), recipe(8, 4), even};
}

} // namespace dewpoint::experiment::scenarios
