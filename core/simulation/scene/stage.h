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

/// Where something is at a time: seconds to meters, world frame.
using Path = std::function<Eigen::Vector3d(double)>;

/// The parts of a body at a time, seconds: along the world's axes, relative to the body's path; as
/// many in the same order at every time.
using PartsPath = std::function<std::vector<MovingPart>(double)>;

/// An object that moves on a stage: a ball, a box (a flat one is a patch or an occluder), or a body
/// of parts.
struct StageBody {
  std::string name;
  bool box = false;
  double radius = kUsualBallRadius;                   ///< of the ball or a body's own ball, meters
  Eigen::Vector3d halfSize = Eigen::Vector3d::Zero(); ///< of the box along its own axes, meters
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< of the box; rows: its axes in the world
  Eigen::Vector3d color = kUsualBallColor;            ///< BGR in full light, [0, 255]
  Path path;
  std::function<bool(double)> present; ///< at a time; none: always
  /// None: a plain ball or box. Otherwise it is drawn from its parts alone. Where parts are marked
  /// as target its true position is the centroid of those, elsewhere it is `path` as for a ball.
  PartsPath parts{};
  /// The `radius` that the parts are made for: with another one they are larger or smaller.
  double partsRadius = kUsualBallRadius;

  /// Radius of a sphere around it, meters; of a body of parts around its own ball.
  double bound() const { return box ? halfSize.norm() : radius; }
  bool presentAt(double time) const { return !present || present(time); }
  /// Its parts at a time, scaled, relative to its path; empty if it has none.
  std::vector<MovingPart> partsAt(double time) const;
};

/// The light that one camera gets at one time.
struct Light {
  Eigen::Vector3d gain = Eigen::Vector3d::Ones(); ///< per channel, BGR; 1 is full light
  bool dark = false;                              ///< no light at all: a blackout
};

/// A camera that stands elsewhere from some time on.
struct MovedCamera {
  std::size_t camera = 0;
  double since = 0.0; ///< seconds
  std::shared_ptr<const RoomView> view;
};

/// What a camera sees at rest under the stage's illumination; made by prepareLight().
struct RelitView {
  std::shared_ptr<const RoomView> view;
  RelitBackground background;
  Eigen::Vector3d meanGain = Eigen::Vector3d::Ones(); ///< of its mean color (BGR)
};

/// Everything that decides the images of a set-up with known truth: what stands and moves before
/// the cameras, the light and the sensors.
struct Stage {
  std::uint64_t seed = 1; ///< of the sensor noise
  std::vector<StageBody> bodies;
  std::vector<std::shared_ptr<const RoomView>> views; ///< one per camera
  std::vector<MovedCamera> moves;
  std::function<Light(std::size_t camera, double time)> light; ///< none: full light
  std::vector<cv::Mat> unevenness; ///< CV_32FC3 gain per pixel, one per camera; empty: even light
  double noiseSigma = kUsualNoiseSigma;    ///< standard deviation of the sensor noise, gray levels
  double exposureSeconds = kUsualExposure; ///< of cameras without a model of their own
  int jpegQuality = 0;                     ///< 1 to 100: images go through JPEG; 0: they do not
  std::vector<SensorModel> sensors;        ///< one per camera; empty: ideal ones
  Illumination illumination;               ///< besides the lamp that `views` were rendered with
  /// Who walks behind the bodies: bodies hide people, never the other way round. The lamp alone
  /// lights them, and no exposure blurs them.
  std::vector<Walker> people;
  std::vector<MovableFurniture> furniture; ///< that people move; seen as they are
  /// The people are what is recorded: all of the illumination lights them, and shutter and exposure
  /// of the cameras with a model of their own blur them. Needs an illumination that is not plain.
  bool peopleExposed = false;
  float floorHeight = 0.0F;     ///< world z of the floor that they walk on, meters
  std::vector<RelitView> relit; ///< of all views, where the illumination is not plain
};

/// Computes what follows from the stage's illumination: to be called when it or a view was set.
void prepareLight(Stage& stage);

/// How much more light than nominal a camera meters at a time, per channel (BGR), in stops: from
/// the stage's light and illumination, on what is at rest. A blackout counts as kDarkStops: a
/// sixteenth of the light, chosen, beyond what ControlLoop::limit lets a camera make up for.
Eigen::Vector3d meteredStops(const Stage& stage, std::size_t camera, double time);
inline constexpr double kDarkStops = -4.0;

/// The image (CV_8UC3, BGR) of one camera with its exposure centered on `time` (seconds): a pure
/// function of its arguments. `frame` is the camera's frame number and chooses the noise.
cv::Mat renderStage(const Stage& stage, std::size_t camera, double time, std::int64_t frame);

} // namespace dewpoint::simulation
