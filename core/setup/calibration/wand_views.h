// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/wand/wand_calibration.h"
#include "core/capture/frame_source.h"
#include "core/observation/sphere/marker_detection.h"
#include "core/project/project.h"
#include "core/setup/calibration/calibrated_project.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Collects detections of the balls of a wand from consecutive frame sets, live or recorded.
class WandViews {
public:
  /// Creates one detector per ball: one, or two for a stick.
  WandViews(std::size_t cameraCount, const std::vector<ColorClassifier>& balls);

  /// Searches the images of a frame set for the balls.
  void add(const FrameSet& frames);
  /// Returns the detections of each camera, in the order of the frames.
  const std::vector<std::vector<MarkerObservation>>& views() const { return views_; }
  /// Returns the detections since the last call, and removes them from this object.
  std::vector<std::vector<MarkerObservation>> takeViews();
  std::int64_t frameSetCount() const { return frameSets_; }

private:
  std::vector<MarkerDetector> finders_;
  std::vector<std::vector<MarkerObservation>> views_;
  std::int64_t frameSets_ = 0;
};

/// Options of a calibration with a wand (a colored ball, or a stick with two balls, that is waved).
struct WandOptions {
  /// Names of the targets that are the wand: one ball, or the two ends of a stick; empty: the
  /// project's only target.
  std::vector<std::string> targets;
  double stickLength = 0.0; ///< for a stick: distance between its two balls, meters
  std::int64_t firstFrame = 0;
  /// One past the last frame that is searched; not set: up to the end.
  std::optional<std::int64_t> endFrame;
  bool estimatesTimeOffsets = false;
  bool estimatesFocalLengths = false;
  bool estimatesDistortion = false;
  /// True to determine the scale from the radius of the ball in the project.
  bool usesBallDiameter = false;
  std::optional<TouchedDistance> touchedDistance;
  /// Times at which the first ball lies on the floor or touches it, seconds.
  std::vector<double> floorTimes;
  /// Times at which the ball begins and ends a free fall, seconds.
  std::optional<std::array<double, 2>> freeFallSpan;
  /// Possible error of the project's camera positions, meters.
  double initialPositionError = kInitialPositionError;
  /// Possible error of the project's camera orientations, radians.
  double initialRotationError = kInitialRotationError;
};

/// Creates the calibration problem for a project and options. It contains no views; the caller must
/// add them. The initial rig and the radii of the balls come from the project; everything else
/// comes from the options. Fails if a target is unknown or a stick has no length.
Result<WandProblem> makeWandProblem(const Project& project, const WandOptions& options);
/// Returns one color classifier per ball, made from the color of the target that is named in the
/// options.
Result<std::vector<ColorClassifier>> wandColorClassifiers(const Project& project,
                                                          const WandOptions& options);

/// Progress of a calibration by wand.
struct WandCalibrationProgress {
  bool isSearching = true; ///< true: searching the images; false: solving
  std::int64_t doneStepCount = 0;
  std::int64_t totalStepCount =
      0;              ///< number of steps of the search or solution in total; 0 if unknown
  double rmsPx = 0.0; ///< reprojection error in pixels, while solving
};
/// Function that receives the progress of a calibration. It returns false to stop the calibration.
using WandCalibrationCallback = std::function<bool(const WandCalibrationProgress&)>;

/// Calibrates the cameras from collected views of the balls of a wand, live or from a recording.
/// The command line and the window give bit-identical results. The given project is not changed. If
/// a known fault, such as exchanged cameras, explains the views better than the given project does,
/// the result or the error names the fault.
Result<WandResult> calibrateFromViews(const Project& project,
                                      const std::vector<std::vector<MarkerObservation>>& views,
                                      const WandOptions& options,
                                      const WandCalibrationCallback& callback = nullptr);

/// Searches a recording for the balls of the wand and calibrates the cameras from them.
Result<WandResult> calibrateFromRecording(const Project& project, FrameSetSource& source,
                                          const WandOptions& options,
                                          const WandCalibrationCallback& callback = nullptr);

} // namespace dewpoint::setup
