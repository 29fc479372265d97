// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/bundle/bundle_adjustment.h"
#include "core/calibration/bundle/fault.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::calibration {

/// A ball in one image.
struct MarkerObservation {
  double time = 0.0;                               ///< seconds, by the camera's own clock
  std::size_t ball = 0;                            ///< 0, or 1 for the other end of a stick
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero(); ///< center of its outline
  double radius = 0.0;                             ///< of the outline, pixels; 0: not measured
  double sigma = 0.3;                              ///< standard deviation of `pixel` per axis
};

/// What gives the result its size.
enum class WandScale {
  InitialRig, ///< the initial rig: sizes are only as good as it
  Stick,      ///< the known length of the stick
  Distance,   ///< between two positions that were touched
  Diameter    ///< the ball's apparent radius: to about 0.05 px of it
};

/// The ball was held at two positions a known distance apart.
struct TouchedDistance {
  double firstTime = 0.0;  ///< seconds
  double secondTime = 0.0; ///< seconds
  double meters = 0.0;
};

/// A wand, and how its images are to be read.
struct WandProblem {
  CameraRig initialRig;                              ///< where the cameras are, roughly
  std::vector<std::vector<MarkerObservation>> views; ///< per camera of `initialRig`
  std::array<double, 2> ballRadius = {0.0, 0.0};     ///< meters; 0: unknown, taken for points
  double stickLength = 0.0; ///< between the middles of balls 0 and 1, meters; 0: one ball
  WandScale scale = WandScale::InitialRig;
  TouchedDistance distance;                  ///< for WandScale::Distance
  std::vector<double> floorTimes;            ///< when ball 0 lay on or touched the floor, seconds
  std::optional<std::array<double, 2>> drop; ///< ball 0 fell freely from .. until, seconds
  bool findOffsets = false;                  ///< time offsets of the cameras against the first
  bool findFocal = false;                    ///< focal lengths, in their ratio
  bool findDistortion = false;               ///< k1 of every camera
  double initialTurnError = 0.06;            ///< by how much the initial rig may be off, radians
  double initialPositionError = 0.12;        ///< meters
  int starts = 6;                            ///< the initial rig, and it perturbed by as much
  std::uint64_t seed = 1;                    ///< of the perturbations
  int mostInstants = 900;                    ///< used, spread evenly over the recording
};

/// One of the starts: how well its solution explains the images.
struct WandStart {
  bool solved = false;
  double medianPx = 0.0; ///< length of the residuals
};

/// What was read off a fall.
struct WandDrop {
  double gravity = 0.0;     ///< meters per second squared; 9.81 if the scale is right
  double sigma = 0.0;       ///< its standard deviation
  std::size_t instants = 0; ///< used
};

/// A calibration by wand.
struct WandResult {
  CameraRig cameras;                  ///< named as the initial ones
  std::vector<double> offsets;        ///< seconds; true time = camera's time + offset
  std::vector<double> cameraMedianPx; ///< length of the residuals kept
  double medianPx = 0.0;
  std::vector<std::size_t> views;   ///< per camera, used
  std::vector<std::size_t> dropped; ///< per camera, taken for gross errors
  std::vector<WandStart> starts;
  WandScale scale = WandScale::InitialRig;
  double scaleFactor = 1.0; ///< by which sizes were corrected against the initial rig
  double scaleSigma = 0.0;  ///< relative standard deviation of the size; 0: not known
  bool floorFound = false;
  double floorRms = 0.0; ///< meters, of the touched positions about the plane
  std::optional<WandDrop> drop;
  double upRotated = 0.0;              ///< radians between the initial rig's up and the result's
  BundleProblem problem;               ///< what was adjusted last, in the result's world
  BundleResult bundle;                 ///< and its outcome, with the covariance
  double seconds = 0.0;                ///< of computing
  std::vector<NamedFault> faults = {}; ///< left to findWandFaults()
};

/// Where the computation is. Return false to stop it.
struct WandProgress {
  int step = 0;
  int steps = 0;
  double rms = 0.0; ///< pixels
};
using WandCallback = std::function<bool(const WandProgress&)>;

/// Poses (focal lengths, k1, time offsets) of all cameras from a wand (a waved ball or stick),
/// starting from an initial rig: bundle adjustment with robust losses, narrowed in steps, from
/// several starts; views that no solution explains are dropped one per instant and round. The world
/// stays aligned to the initial rig unless floor touches or a fall say where up is. Deterministic.
///
/// Errors: too few views of a camera (named), cameras that are not connected by common views,
/// touches at times when the ball was not seen by two cameras, and Cancelled.
Result<WandResult> calibrateFromWand(const WandProblem& problem,
                                     const WandCallback& callback = nullptr);

} // namespace dewpoint::calibration
