// SPDX-License-Identifier: GPL-3.0-or-later
// S22: balls of seven colors, whose range is learned from one sloppy click in the first images.
#include "core/color/color_sample.h"
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/scenario_places.h"
#include "core/setup/click_lesson.h"
#include "core/simulation/scene/scene.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace dewpoint::experiment::scenarios {
namespace {

/// Where somebody clicks: a camera, and a point of the ball's disc as its camera sees it, in radii
/// to the right and down.
struct Click {
  std::size_t camera = 0;
  Eigen::Vector2d aside = Eigen::Vector2d::Zero();
};

/// Anywhere on the disc but its rim.
Click drawClick(Draws& draws, std::size_t cameras) {
  constexpr double kWithin = 0.8; // of the disc's radius; chosen: nobody clicks on the rim itself
  Click click;
  click.camera = static_cast<std::size_t>(draws.whole(0, static_cast<int>(cameras) - 1));
  const double radius = kWithin * std::sqrt(draws.uniform(0.0, 1.0));
  const double angle = draws.uniform(0.0, kFullTurn);
  click.aside = radius * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  return click;
}

/// The pixel of a click on a ball; nothing where the camera does not have it.
std::optional<Eigen::Vector2d> pixelOf(const Camera& camera, const simulation::StageBody& ball,
                                       const Eigen::Vector2d& aside) {
  const Eigen::Vector3d center = ball.path(0.0);
  const Eigen::Vector3d sight = (center - camera.center()).normalized();
  const Eigen::Vector3d across = camera.cameraFromWorld.linear().row(0).transpose();
  const Eigen::Vector3d right = (across - across.dot(sight) * sight).normalized();
  const Eigen::Vector3d down = sight.cross(right);
  const Eigen::Vector3d offset = ball.radius * (aside.x() * right + aside.y() * down);
  return Projector(camera).project(center + offset);
}

/// What `dewpoint-cli learn-color` makes of one click; nothing where it fails.
std::optional<setup::ClickLesson> learnFrom(const CameraRig& rig,
                                            const std::vector<cv::Mat>& images, std::size_t camera,
                                            const Eigen::Vector2d& pixel) {
  ColorSample click;
  click.camera = static_cast<int>(camera);
  click.x = std::round(pixel.x());
  click.y = std::round(pixel.y());
  const auto sample = takeSample(images.at(camera), click);
  if (!sample) {
    return std::nullopt;
  }
  auto lesson = setup::learnFromClicks(rig, {.images = images, .emptyRooms = {}}, {*sample});
  return lesson ? std::optional(std::move(*lesson)) : std::nullopt;
}

/// Sets the first target's color to what the click teaches, in the images as the grade has them.
/// Where the product cannot learn from it, it is told so and clicks again, in the middle; where
/// that fails too, the target keeps the range of a new target, which next to nothing matches.
void teach(const ScenarioDraft& draft, const Click& click, ScenarioRun& run) {
  const FrameSetPtr first = run.frames(0);
  std::vector<cv::Mat> images;
  for (const FramePtr& frame : first->frames) {
    images.push_back(frame ? frame->image : cv::Mat());
  }
  Target& target = run.targets.front();
  target.color = ColorRange{};
  const simulation::StageBody& ball = draft.stage.bodies[draft.targets.front()];
  for (const Eigen::Vector2d& aside : {click.aside, Eigen::Vector2d::Zero().eval()}) {
    const auto pixel = pixelOf(draft.rig[click.camera], ball, aside);
    const auto lesson = pixel ? learnFrom(run.rig, images, click.camera, *pixel) : std::nullopt;
    if (lesson) {
      target.color = lesson->color.range;
      target.samples = lesson->samples;
      return;
    }
  }
}

bool clicked(ScenarioDraft& draft, const Eigen::Vector3d& color) {
  if (!addDeskBall(draft, kUsualFrames)) {
    return false;
  }
  draft.stage.bodies.back().color = color;
  const Click click = drawClick(draft.draws, draft.rig.size());
  draft.teach = [click](const ScenarioDraft& finished, ScenarioRun& run) {
    teach(finished, click, run);
  };
  return true;
}

} // namespace

std::vector<ScenarioRecipe> clickedScenarios() {
  const auto recipe = [](const char* word, const Eigen::Vector3d& color) {
    ScenarioRecipe result{
        fmt::format("S22-{}", word),
        fmt::format("A {} ball whose color is learned from one sloppy click.", word), demoRig()};
    result.complete = [color](ScenarioDraft& draft) { return clicked(draft, color); };
    result.targetColor = color;
    return result;
  };
  // BGR in full light; chosen: toys and balls as one can buy them.
  return {recipe("pink", simulation::kUsualBallColor), recipe("orange", {40.0, 140.0, 245.0}),
          recipe("blue", {220.0, 90.0, 40.0}),         recipe("red", {40.0, 40.0, 215.0}),
          recipe("yellow", {50.0, 215.0, 240.0}),      recipe("green", {70.0, 170.0, 50.0}),
          recipe("gray", {150.0, 150.0, 150.0})};
}

} // namespace dewpoint::experiment::scenarios
