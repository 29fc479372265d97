// SPDX-License-Identifier: GPL-3.0-or-later
// S22: balls of seven colors, whose range is learned from one sloppy click in the first images, and
// one of two colors, each of which is clicked.
#include "core/color/color_sample.h"
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/scenario_paths.h"
#include "core/experiment/scenarios/targets/patterned_ball.h"
#include "core/setup/clicks/click_learning.h"
#include "core/simulation/scene/scene.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace dewpoint::experiment::scenarios {
namespace {

/// Of a disc's radius, where people click; chosen: nobody clicks on the rim itself.
constexpr double kClickedWithin = 0.8;

/// Where somebody clicks: a camera, and a point of the ball's disc as its camera sees it, in radii
/// to the right and down.
struct Click {
  std::size_t camera = 0;
  Eigen::Vector2d aside = Eigen::Vector2d::Zero();
};

/// Anywhere on the disc but its rim.
Click drawClick(RandomDraws& draws, std::size_t cameras) {
  Click click;
  click.camera = static_cast<std::size_t>(draws.drawInteger(0, static_cast<int>(cameras) - 1));
  const double radius = kClickedWithin * std::sqrt(draws.drawUniform(0.0, 1.0));
  const double angle = draws.drawUniform(0.0, kFullTurn);
  click.aside = radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  return click;
}

/// A ball's disc as a camera sees it: columns to the right, down and along the sight, world.
Eigen::Matrix3d discAxes(const Camera& camera, const Eigen::Vector3d& center) {
  const Eigen::Vector3d sight = (center - camera.center()).normalized();
  const Eigen::Vector3d across = camera.cameraFromWorld.linear().row(0).transpose();
  const Eigen::Vector3d right = (across - across.dot(sight) * sight).normalized();
  Eigen::Matrix3d axes;
  axes << right, sight.cross(right), sight;
  return axes;
}

/// The pixel of a click on a ball; nothing where the camera does not have it.
std::optional<Eigen::Vector2d> pixelOf(const Camera& camera, const simulation::StageBody& ball,
                                       double time, const Eigen::Vector2d& aside) {
  const Eigen::Vector3d center = ball.path(time);
  return Projector(camera).project(center +
                                   ball.radius * (discAxes(camera, center).leftCols<2>() * aside));
}

std::vector<cv::Mat> imagesOf(const ScenarioRun& run, std::int64_t frame) {
  const FrameSetPtr set = run.frames(frame);
  std::vector<cv::Mat> images;
  for (const FramePtr& shown : set->frames) {
    images.push_back(shown ? shown->image : cv::Mat());
  }
  return images;
}

/// What `dewpoint-cli learn-color` makes of clicks in one frame; nothing where it fails.
std::optional<setup::ClickLearningResult> learnFrom(const ScenarioDraft& draft,
                                                    const ScenarioRun& run, std::int64_t frame,
                                                    const std::vector<Click>& clicks) {
  const std::vector<cv::Mat> images = imagesOf(run, frame);
  const simulation::StageBody& ball = draft.stage.bodies[draft.targets.front()];
  std::vector<ColorSample> samples;
  for (const Click& click : clicks) {
    const auto pixel = pixelOf(draft.rig[click.camera], ball, draft.timeOf(frame), click.aside);
    if (!pixel) {
      return std::nullopt;
    }
    ColorSample place;
    place.camera = static_cast<int>(click.camera);
    place.frame = frame;
    place.x = std::round(pixel->x());
    place.y = std::round(pixel->y());
    const auto sample = takeSample(images.at(click.camera), place);
    if (!sample) {
      return std::nullopt;
    }
    samples.push_back(*sample);
  }
  auto result = setup::learnFromClicks(
      run.rig, {.images = images, .backgroundImages = {}, .frame = frame}, samples);
  return result ? std::optional(std::move(*result)) : std::nullopt;
}

/// Gives the first target what was learned; else it keeps the range of a new target, which next to
/// nothing matches.
void take(const std::optional<setup::ClickLearningResult>& result, ScenarioRun& run) {
  Target& target = run.targets.front();
  target.color = ColorRange{};
  if (result) {
    target.color = result->color.range;
    target.otherColors = result->color.otherRanges;
    target.samples = result->samples;
  }
}

/// Sets the first target's color to what the click teaches, in the images as the grade has them.
/// Where the product cannot learn from it, it is told so and clicks again, in the middle.
void teach(const ScenarioDraft& draft, const Click& click, ScenarioRun& run) {
  auto result = learnFrom(draft, run, 0, {click});
  if (!result) {
    result = learnFrom(draft, run, 0, {{click.camera, Eigen::Vector2d::Zero()}});
  }
  take(result, run);
}

/// A color of a ball as one camera shows it: how many of the points that were looked at have it,
/// and the one of them that is nearest to their middle.
struct ShownColor {
  simulation::Vector3f color;
  std::vector<Eigen::Vector2d> points{}; ///< as Click::aside

  Eigen::Vector2d middle() const {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& point : points) {
      mean += point / static_cast<double>(points.size());
    }
    return *std::ranges::min_element(
        points, {}, [&](const Eigen::Vector2d& point) { return (point - mean).squaredNorm(); });
  }
};

/// The colors of a ball at a time in a camera's image, within `kClickedWithin` radii.
std::vector<ShownColor> colorsShown(const Camera& camera, const simulation::StageBody& ball,
                                    double time) {
  constexpr double kStep = 0.1; // radii: some two hundred points are looked at
  const auto parts = ball.parts(time);
  const Eigen::Matrix3d axes = discAxes(camera, ball.path(time));
  std::vector<ShownColor> shown;
  const int steps = static_cast<int>(std::lround(kClickedWithin / kStep));
  for (int i = -steps; i <= steps; ++i) {
    for (int j = -steps; j <= steps; ++j) {
      const Eigen::Vector2d aside(kStep * i, kStep * j);
      if (aside.norm() > kClickedWithin) {
        continue;
      }
      const Eigen::Vector3d normal =
          axes * Eigen::Vector3d(aside.x(), aside.y(), -std::sqrt(1.0 - aside.squaredNorm()));
      const auto color = parts.front().colorAt(normal.cast<float>());
      auto known = std::ranges::find(shown, color, &ShownColor::color);
      if (known == shown.end()) {
        known = shown.insert(shown.end(), {color});
      }
      known->points.push_back(aside);
    }
  }
  return shown;
}

/// Somebody waits until a camera shows both colors well, and clicks the middle of each there.
void teachBothColors(const ScenarioDraft& draft, ScenarioRun& run) {
  constexpr std::int64_t kEvery = 5; // frames
  constexpr double kWell = 0.35;     // of the disc, the smaller part; chosen
  const simulation::StageBody& ball = draft.stage.bodies[draft.targets.front()];
  double best = 0.0;
  std::int64_t frame = 0;
  std::vector<Click> clicks;
  for (std::int64_t k = 0; k < draft.frameCount && best < kWell; k += kEvery) {
    for (std::size_t camera = 0; camera < draft.rig.size(); ++camera) {
      const auto shown = colorsShown(draft.rig[camera], ball, draft.timeOf(k));
      if (shown.size() != 2) {
        continue;
      }
      const auto one = static_cast<double>(shown[0].points.size());
      const auto other = static_cast<double>(shown[1].points.size());
      if (const double share = std::min(one, other) / (one + other); share > best) {
        best = share;
        frame = k;
        clicks = {{camera, shown[0].middle()}, {camera, shown[1].middle()}};
      }
    }
  }
  take(clicks.empty() ? std::nullopt : learnFrom(draft, run, frame, clicks), run);
}

bool bothColorsClicked(ScenarioDraft& draft) {
  if (!addDeskBall(draft, kDefaultFrameCount)) {
    return false;
  }
  const Spin spin = randomSpin(draft.draws, kSlowestSpin, kFastestSpin);
  paintBall(draft.stage.bodies.back(), BallPattern::TwoColors, spin, draft.draws);
  draft.learnTargets = teachBothColors;
  return true;
}

bool clicked(ScenarioDraft& draft, const Eigen::Vector3d& color) {
  if (!addDeskBall(draft, kDefaultFrameCount)) {
    return false;
  }
  draft.stage.bodies.back().color = color;
  const Click click = drawClick(draft.draws, draft.rig.size());
  draft.learnTargets = [click](const ScenarioDraft& finished, ScenarioRun& run) {
    teach(finished, click, run);
  };
  return true;
}

} // namespace

std::vector<ScenarioRecipe> clickedTargetScenarios() {
  const auto recipe = [](const char* word, const Eigen::Vector3d& color) {
    ScenarioRecipe result{
        fmt::format("S22-{}", word),
        fmt::format("A {} ball whose color is learned from one sloppy click.", word), demoRig()};
    result.complete = [color](ScenarioDraft& draft) { return clicked(draft, color); };
    result.targetColor = color;
    return result;
  };
  // BGR in full light; chosen: toys and balls as one can buy them.
  ScenarioRecipe twoColors{
      "S22-two-colors", "A rotating ball of two colors, each of which is clicked once.", demoRig()};
  twoColors.complete = bothColorsClicked;
  return {recipe("pink", simulation::kDefaultBallColor), recipe("orange", {40.0, 140.0, 245.0}),
          recipe("blue", {220.0, 90.0, 40.0}),           recipe("red", {40.0, 40.0, 215.0}),
          recipe("yellow", {50.0, 215.0, 240.0}),        recipe("green", {70.0, 170.0, 50.0}),
          recipe("gray", {150.0, 150.0, 150.0}),         twoColors};
}

} // namespace dewpoint::experiment::scenarios
