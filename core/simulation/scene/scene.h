// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/simulation/body/usual_ball.h"
#include "core/simulation/room/light.h"
#include "core/simulation/sensor/usual_camera.h"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace dewpoint::simulation {

/// Motion of a simulated ball.
enum class Motion {
  Still,  ///< stays at its position
  Smooth, ///< a closed three-dimensional Lissajous path around its position
  Fast,   ///< the same path as Smooth, five times as fast
  Jump,   ///< rests, but changes its position from one frame to the next once per `period`
};

/// Center of the volume above the desk, toward which all cameras at the desk are aimed. World
/// frame, meters. Chosen to be half a meter in front of both cameras of demoRig().
inline const Eigen::Vector3d kDeskCenter{0.5, 0.5, 0.15};

/// Focal length of the cameras at the desk, pixels. With this focal length, the field of view is 49
/// degrees across 320 pixels. Chosen by judgment.
inline constexpr double kDeskFocal = 350.0;

/// Ball of a simulated scene. Its true position is known at every time.
struct SceneBall {
  std::string name = "pink ball";
  double radius = kDefaultBallRadius;        ///< meters
  Eigen::Vector3d color = kDefaultBallColor; ///< BGR in full light, [0, 255]
  Motion motion = Motion::Smooth;
  /// Initial position of the ball and center of its path; world frame, meters.
  Eigen::Vector3d position = kDeskCenter;
  Eigen::Vector3d pathHalfSize{0.12, 0.08, 0.05}; ///< half size of the path along X, Y, Z, meters
  double period =
      6.0; ///< duration of one round of a smooth path, or time between two jumps, seconds
  double stillSeconds = 0.0; ///< time at rest before the ball starts to move, seconds

  // HSI ranges that contain the rendered pixels of the ball and almost no others. Hue is in degrees
  // and circular: if hueMin > hueMax, the range contains 0. Saturation and intensity are in [0, 1].
  double hueMin = 320.0;
  double hueMax = 352.0;
  double saturationMin = 0.25;
  double saturationMax = 0.65;
  double intensityMin = 0.15;
  double intensityMax = 0.90;
};

/// Light at one time: an entry of Scene::lights. Between the times of two entries, the light is
/// interpolated, with brightness on a logarithmic scale. Before the first and after the last entry,
/// the light is constant.
struct SceneLight {
  double time = 0.0;       ///< seconds
  double brightness = 1.0; ///< factor; 1 is full light
  /// Color temperature of the light, kelvin; the cameras are balanced for 5500 K.
  double colorTemperature = kBalancedKelvin;
};

/// Maximum number of distractors (balls at rest with the color of the first ball), which is the
/// number of positions for them on the desk.
inline constexpr int kMaxDistractors = 4;

/// Simulated scene: everything that determines the images and the true positions. Frame f is taken
/// at f / framesPerSecond seconds, and its exposure is centered on this time.
struct Scene {
  std::string name = "demo";
  CameraRig cameras;
  double framesPerSecond = kDefaultFrameRate;
  std::int64_t frameCount = 300;
  std::uint64_t seed = 1;
  std::vector<SceneBall> balls;
  /// Number of distractors, up to kMaxDistractors. Distractors are additional balls at rest, with
  /// the color of the first ball.
  int distractorCount = 0;
  /// True to add a box that passes between the first ball and the first camera.
  bool hasOccluder = false;
  bool hasClutter =
      true; ///< true to add books, boxes, and wood- and skin-colored objects on the desk
  std::vector<SceneLight> lights;         ///< in order of time; empty: always full light of 5500 K
  double noiseSigma = kDefaultNoiseSigma; ///< standard deviation of the sensor noise, gray levels
  double exposureSeconds =
      kDefaultExposureSeconds; ///< exposure time, which determines the motion blur
};

/// Returns the setup of Barrera, Cañas and Matellán (2005): two cameras at the paper's positions,
/// looking at (0.5, 0.5, 0.15), with focal lengths of 350 px. Camera 2 has a portrait image.
CameraRig demoRig();

/// Returns the built-in default scene with the demo rig. The ball rests for 60 frames and then
/// moves on a smooth path.
Scene demoScene();

/// Returns the true center of a ball at `time` seconds, world frame, meters.
Eigen::Vector3d ballPosition(const Scene& scene, int ball, double time);

/// Returns the position of distractor number `index` (a ball at rest with the color of the first
/// ball), world frame, meters.
Eigen::Vector3d distractorPosition(const Scene& scene, int index);

/// Returns the center of the occluder (a box that hides the first ball from the first camera) at
/// `time` seconds, world frame, meters.
Eigen::Vector3d occluderPosition(const Scene& scene, double time);

/// Returns the light at `time` seconds, as a factor per channel (BGR).
Eigen::Vector3d lightGain(const Scene& scene, double time);

/// Returns the time in seconds of frame `frame`.
double frameTime(const Scene& scene, std::int64_t frame);

} // namespace dewpoint::simulation
