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

/// Function that returns a position (world frame, meters) at a time (seconds).
using Path = std::function<Eigen::Vector3d(double)>;

/// Function that returns the parts of a body at a time (seconds). Positions are relative to the
/// body's position on its path, along the world axes (meters). The number and order of the parts
/// must not depend on the time.
using PartsPath = std::function<std::vector<MovingPart>(double)>;

/// Moving object on a stage: a ball, a box, or a body made of parts. A flat box can serve as a
/// patch or an occluder.
struct StageBody {
  std::string name;
  bool isBox = false;
  /// Radius of the ball, meters. A body made of parts is scaled with this radius: its parts have
  /// the right size if `radius` equals `nominalRadius`.
  double radius = kDefaultBallRadius;
  Eigen::Vector3d halfSize =
      Eigen::Vector3d::Zero(); ///< half size of the box along its own axes, meters
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity(); ///< axes of the box in the world, as rows
  Eigen::Vector3d color = kDefaultBallColor;          ///< BGR in full light, [0, 255]
  Path path;
  std::function<bool(double)>
      present; ///< returns whether the object is present at a time (seconds); empty: always present
  /// Parts of a body; empty for a plain ball or box. If there are parts, only the parts are drawn.
  /// If some parts are marked as target, the true position is the centroid of these parts.
  /// Otherwise the true position is `path`, as for a ball.
  PartsPath parts{};
  /// Value of `radius` for which the parts have the right size. For other values of `radius`, the
  /// parts are scaled.
  double nominalRadius = kDefaultBallRadius;

  /// Returns the radius (meters) of a sphere around the object. For a body made of parts, this is
  /// only `radius`, so parts can lie outside the sphere.
  double boundingRadius() const { return isBox ? halfSize.norm() : radius; }
  bool isPresentAt(double time) const { return !present || present(time); }
  /// Returns the scaled parts at a time (seconds), relative to the path. The result is empty if the
  /// object has no parts.
  std::vector<MovingPart> partsAt(double time) const;
};

/// Light that one camera receives at one time.
struct Light {
  Eigen::Vector3d gain = Eigen::Vector3d::Ones(); ///< gain per channel, BGR; 1 is full light
  bool isDark = false;                            ///< true if the camera receives no light at all
};

/// Camera whose pose changes once, at the time `moveTimeSeconds`. `view` shows the room at rest
/// from the new pose.
struct MovedCamera {
  std::size_t camera = 0;
  double moveTimeSeconds = 0.0; ///< time of the change, seconds
  std::shared_ptr<const RoomView> view;
};

/// Camera view of the room at rest under the stage's illumination. Computed by prepareLight().
struct RelitView {
  std::shared_ptr<const RoomView> view;
  RelitBackground background;
  /// Mean color of the room at rest with the illumination, divided by its mean color without it,
  /// per channel (BGR).
  Eigen::Vector3d meanGain = Eigen::Vector3d::Ones();
};

/// Everything that determines the simulated images: objects at rest, moving objects, light and
/// sensors. The true positions of the objects are known.
struct Stage {
  std::uint64_t seed = 1; ///< seed of the sensor noise
  std::vector<StageBody> bodies;
  std::vector<std::shared_ptr<const RoomView>> views; ///< view of the room at rest from each camera
  std::vector<MovedCamera> movedCameras;
  /// Light that each camera receives; empty: full light.
  std::function<Light(std::size_t camera, double time)> light;
  std::vector<cv::Mat>
      illuminationGains; ///< CV_32FC3 gain per pixel, one per camera; empty: even light
  double noiseSigma = kDefaultNoiseSigma; ///< standard deviation of the sensor noise, gray levels
  double exposureSeconds =
      kDefaultExposureSeconds;      ///< exposure time of cameras without a sensor model, seconds
  int jpegQuality = 0;              ///< 1 to 100: images are compressed as JPEG; 0: no compression
  std::vector<SensorModel> sensors; ///< model of each camera's sensor; empty: ideal sensors
  /// Light of the room, if it differs from the light of the lamp with which `views` were rendered.
  Illumination illumination;
  /// People who walk behind the bodies. Bodies can hide people, but people never hide bodies.
  /// Unless `arePeopleMainSubject` is set, people are lit only by the room lamp and have no motion
  /// blur.
  std::vector<Walker> people;
  std::vector<MovableFurniture> furniture; ///< furniture that people move
  /// True if people are the subject of the recording. All lamps of the illumination then light
  /// them, and cameras with a sensor model record them with motion blur and rolling shutter.
  /// Requires an illumination that is not the default.
  bool arePeopleMainSubject = false;
  float floorHeight = 0.0F; ///< world z of the floor on which people walk, meters
  /// Images of all views, including those of moved cameras, under the illumination; empty if the
  /// illumination is the default.
  std::vector<RelitView> relitViews;
};

/// Computes Stage::relitViews from the stage's illumination and views. Call this function after
/// changing the illumination, `views` or `movedCameras`.
void prepareLight(Stage& stage);

/// Returns the brightness that a camera's automatic control measures at a time (seconds), per
/// channel (BGR), in stops (factors of two) relative to the nominal light. The brightness is
/// computed from `Stage::light` and from the mean gain of `Stage::illumination` on the room at
/// rest; moving objects are ignored. Complete darkness counts as kDarkStops.
Eigen::Vector3d meteredBrightnessStops(const Stage& stage, std::size_t camera, double time);
/// Result of meteredBrightnessStops() in complete darkness, in stops: a sixteenth of the nominal
/// light. Chosen so that a camera cannot compensate for it (ControlLoop::maxCorrectionStops).
inline constexpr double kDarkStops = -4.0;

/// Renders the image (CV_8UC3, BGR) of one camera with the exposure centered on `time` (seconds).
/// `frame` is the frame number of the camera, which selects the random numbers for the noise. The
/// result depends only on the arguments.
cv::Mat renderStage(const Stage& stage, std::size_t camera, double time, std::int64_t frame);

} // namespace dewpoint::simulation
