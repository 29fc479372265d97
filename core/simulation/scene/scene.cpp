// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/scene/scene.h"

#include "core/simulation/room/light.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dewpoint::simulation {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Speed of Motion::Fast against Smooth; chosen.
constexpr double kFastFactor = 5.0;
/// The ball gathers speed over this part of a period, instead of starting with a jerk; chosen.
constexpr double kEaseOfPeriod = 0.1;

/// Where the ball is on its path, relative to its position, in units of its extent.
Eigen::Vector3d smoothOffset(double time, double period) {
  const double ease = kEaseOfPeriod * period;
  const double eased = time - ease * (1.0 - std::exp(-time / ease));
  const double angle = 2.0 * std::numbers::pi * eased / period;
  return {std::sin(angle), std::sin(2.0 * angle), std::sin(3.0 * angle)};
}

Eigen::Vector3d jumpOffset(double time, double period, double frameSeconds) {
  static const std::array<Eigen::Vector3d, 4> positions{
      Eigen::Vector3d{0.0, 0.0, 0.0}, Eigen::Vector3d{1.0, -1.0, 1.0},
      Eigen::Vector3d{-1.0, 0.5, -0.8}, Eigen::Vector3d{0.8, 1.0, -1.0}};
  // Half a frame early, so that no exposure holds the ball at two places.
  const auto jumps = static_cast<std::int64_t>(std::floor((time + 0.5 * frameSeconds) / period));
  return positions[static_cast<std::size_t>(jumps % std::int64_t{positions.size()})];
}

Camera camera(const char* name, int width, int height, const Eigen::Vector3d& position) {
  Camera result;
  result.name = name;
  result.intrinsics = {
      width, height, kDeskFocal, kDeskFocal, (width - 1) / 2.0, (height - 1) / 2.0};
  result.cameraFromWorld = lookAt(position, kDeskCenter);
  return result;
}

} // namespace

CameraRig demoRig() {
  return {camera("camera 1", 320, 240, {0.5, 0.0, 0.195}),
          camera("camera 2", 240, 320, {0.07, 0.485, 0.085})};
}

Scene demoScene() {
  Scene scene;
  scene.cameras = demoRig();
  scene.balls.emplace_back();
  scene.balls.front().stillSeconds = 2.0;
  return scene;
}

Eigen::Vector3d ballPosition(const Scene& scene, int ball, double time) {
  const SceneBall& body = scene.balls.at(static_cast<std::size_t>(ball));
  const double moving = time - body.stillSeconds;
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
  switch (body.motion) {
  case Motion::Still:
    break;
  case Motion::Smooth:
    offset = smoothOffset(std::max(0.0, moving), body.period);
    break;
  case Motion::Fast:
    offset = smoothOffset(std::max(0.0, moving), body.period / kFastFactor);
    break;
  case Motion::Jump:
    offset = jumpOffset(std::max(0.0, moving), body.period, 1.0 / scene.framesPerSecond);
    break;
  }
  return body.position + body.pathHalfSize.cwiseProduct(offset);
}

Eigen::Vector3d distractorPosition(const Scene& scene, int index) {
  // Meters: at rest on the desk, where at least one camera of the demo rig sees it beside the
  // ball's path.
  static constexpr std::array<std::array<double, 2>, kMaxDistractors> kPositions{
      {{0.66, 0.62}, {0.36, 0.70}, {0.80, 0.42}, {0.58, 0.78}}};
  const auto& xy = kPositions.at(static_cast<std::size_t>(index));
  return {xy[0], xy[1], scene.balls.empty() ? kDefaultBallRadius : scene.balls.front().radius};
}

Eigen::Vector3d occluderPosition(const Scene& scene, double time) {
  // On the line from the first camera to the first ball, swinging across it: hidden at a quarter
  // and three quarters of the period.
  constexpr double kPeriod = 8.0;
  constexpr double kSwing = 0.3;
  constexpr double kAlongLine = 0.55;
  if (scene.cameras.empty() || scene.balls.empty()) {
    return Eigen::Vector3d::Zero();
  }
  const Camera& viewer = scene.cameras.front();
  const Eigen::Vector3d eye = viewer.center();
  const Eigen::Vector3d right = viewer.cameraFromWorld.linear().row(0).transpose();
  return eye + kAlongLine * (ballPosition(scene, 0, time) - eye) +
         kSwing * std::cos(2.0 * std::numbers::pi * time / kPeriod) * right;
}

Eigen::Vector3d lightGain(const Scene& scene, double time) {
  const auto& lights = scene.lights;
  if (lights.empty()) {
    return Eigen::Vector3d::Ones();
  }
  const auto next = std::ranges::upper_bound(lights, time, {}, &SceneLight::time);
  const SceneLight& after = next == lights.end() ? lights.back() : *next;
  const SceneLight& before = next == lights.begin() ? lights.front() : *(next - 1);
  const double span = after.time - before.time;
  const double share = span > 0.0 ? (time - before.time) / span : 0.0;
  const double brightness =
      before.brightness * std::pow(after.brightness / before.brightness, share);
  return brightness *
         simulation::colorTemperatureGain(
             before.colorTemperature + share * (after.colorTemperature - before.colorTemperature));
}

double frameTime(const Scene& scene, std::int64_t frame) {
  return static_cast<double>(frame) / scene.framesPerSecond;
}

} // namespace dewpoint::simulation
