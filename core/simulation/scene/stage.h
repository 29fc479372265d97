// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/body/body_painter.h"
#include "core/simulation/body/moving_part.h"
#include "core/simulation/body/usual_ball.h"
#include "core/simulation/people/movable_furniture.h"
#include "core/simulation/people/walker.h"
#include "core/simulation/room/illumination.h"
#include "core/simulation/room/room_view.h"
#include "core/simulation/sensor/sensor_model.h"
#include "core/simulation/sensor/usual_camera.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace dewpoint::simulation {

/// Returns a position at a time: seconds to meters, world frame.
using Path = std::function<Eigen::Vector3d(double)>;

/// Returns the parts of a body at a time in seconds, along the world axes, relative to the body's
/// path, in the same number and order at every time.
using PartsPath = std::function<std::vector<MovingPart>(double)>;

/// A moving object on a stage: a ball, a box (a flat one is a patch or an occluder), or a body made
/// of parts.
struct StageBody {
  std::string name;
  bool box = false;
  /// Radius of the ball, or of the ball in a body of parts, meters.
  double radius = kUsualBallRadius;
  Eigen::Vector3d halfSize = Eigen::Vector3d::Zero(); ///< of the box along its own axes, meters
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< of the box; rows: its axes in the world
  Eigen::Vector3d color = kUsualBallColor;            ///< BGR in full light, [0, 255]
  Path path;
  std::function<bool(double)> present; ///< presence at a time in seconds; empty: always present
  /// Parts of a body, which is then drawn from them alone; empty for a plain ball or box. If parts
  /// are marked as target, its true position is their centroid, otherwise `path` as for a ball.
  PartsPath parts{};
  /// The `radius` for which the parts are made; they are scaled for another one.
  double partsRadius = kUsualBallRadius;

  /// Returns the radius in meters of a sphere around it; for a body of parts, around its own ball.
  double bound() const { return box ? halfSize.norm() : radius; }
  bool presentAt(double time) const { return !present || present(time); }
  /// Returns its parts at a time, scaled, relative to its path; empty if it has none.
  std::vector<MovingPart> partsAt(double time) const;
};

/// Light that one camera receives at one time.
struct Light {
  Eigen::Vector3d gain = Eigen::Vector3d::Ones(); ///< per channel, BGR; 1 is full light
  bool dark = false;                              ///< no light at all
};

/// A camera with another pose from some time on.
struct MovedCamera {
  std::size_t camera = 0;
  double since = 0.0; ///< seconds
  std::shared_ptr<const RoomView> view;
};

/// Image of a camera at rest under the stage's illumination; computed by prepareLight().
struct RelitView {
  std::shared_ptr<const RoomView> view;
  RelitBackground background;
  Eigen::Vector3d meanGain = Eigen::Vector3d::Ones(); ///< gain of its mean color (BGR)
};

/// Everything that determines the images of a setup with known truth: objects at rest and in
/// motion, light and sensors.
struct Stage {
  std::uint64_t seed = 1; ///< of the sensor noise
  std::vector<StageBody> bodies;
  std::vector<std::shared_ptr<const RoomView>> views; ///< one per camera
  std::vector<MovedCamera> moves;
  std::function<Light(std::size_t camera, double time)> light; ///< empty: full light
  std::vector<cv::Mat> unevenness; ///< CV_32FC3 gain per pixel, one per camera; empty: even light
  double noiseSigma = kUsualNoiseSigma;    ///< standard deviation of the sensor noise, gray levels
  double exposureSeconds = kUsualExposure; ///< of cameras without a sensor model
  int jpegQuality = 0; ///< 1 to 100: images are compressed with JPEG; 0: not compressed
  std::vector<SensorModel> sensors; ///< one per camera; empty: ideal sensors
  Illumination illumination;        ///< in addition to the lamp that `views` were rendered with
  /// People who walk behind the bodies: bodies hide people, never the reverse. They are lit by the
  /// lamp alone and have no motion blur.
  std::vector<Walker> people;
  std::vector<MovableFurniture> furniture; ///< furniture that people move
  /// True if people are the subject of the recording: the whole illumination lights them, and they
  /// are blurred by shutter and exposure of cameras with a sensor model. Requires an illumination
  /// that is not plain.
  bool peopleExposed = false;
  float floorHeight = 0.0F;     ///< world z of the floor on which they walk, meters
  std::vector<RelitView> relit; ///< for all views, if the illumination is not plain
};

/// Computes the data derived from the stage's illumination. Call it after the illumination or a
/// view was set.
void prepareLight(Stage& stage);

/// Returns the light that a camera meters at a time relative to the nominal light, per channel
/// (BGR), in stops. It follows from the stage's light and illumination on objects at rest. No light
/// at all counts as kDarkStops: a sixteenth of the light, chosen, beyond what a camera can
/// compensate for with ControlLoop::limit.
Eigen::Vector3d meteredStops(const Stage& stage, std::size_t camera, double time);
/// Light metered in the dark, in stops.
inline constexpr double kDarkStops = -4.0;

/// Renders the image (CV_8UC3, BGR) of one camera with its exposure centered on `time` (seconds): a
/// pure function of its arguments. `frame` is the camera's frame number and selects the noise.
cv::Mat renderStage(const Stage& stage, std::size_t camera, double time, std::int64_t frame);

} // namespace dewpoint::simulation
