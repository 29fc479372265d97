// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/wand/wand_calibration.h"
#include "core/capture/frame_source.h"
#include "core/observation/sphere/marker_detection.h"
#include "core/project/project.h"
#include "core/setup/calibrated_project.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Collects where the balls of a wand are seen, frame set after frame set, live or recorded.
class WandViews {
public:
  /// One finder per ball: one, or two of a stick.
  WandViews(std::size_t cameraCount, const std::vector<ColorClassifier>& balls);

  void add(const FrameSet& frames);
  /// Per camera, in the order of the frames.
  const std::vector<std::vector<MarkerObservation>>& views() const { return views_; }
  /// Hands out what was found since the last time.
  std::vector<std::vector<MarkerObservation>> take();
  std::int64_t frameSets() const { return frameSets_; }

private:
  std::vector<MarkerDetector> finders_;
  std::vector<std::vector<MarkerObservation>> views_;
  std::int64_t frameSets_ = 0;
};

/// The user's choices for a calibration by wand.
struct WandOptions {
  std::vector<std::string>
      targets;              ///< names: one ball, or the two ends of a stick; empty: the only
  double stickLength = 0.0; ///< meters
  std::int64_t firstFrame = 0;
  std::optional<std::int64_t> endFrame; ///< one past the last; none: all
  bool findOffsets = false;
  bool findFocal = false;
  bool findDistortion = false;
  bool fromDiameter = false; ///< size from the ball's radius in the project
  std::optional<TouchedDistance> distance;
  std::vector<double> floorTimes; ///< seconds
  std::optional<std::array<double, 2>> drop;
  double initialPositionError = 0.12; ///< meters by which the project's cameras may be off
  double initialTurnError = 0.06;     ///< radians
};

/// The problem that the options make of a project: its cameras as the initial rig, radii and size;
/// views still empty. Errors: no such target, a stick without its length.
Result<WandProblem> wandProblem(const Project& project, const WandOptions& options);
/// The colors of the options' balls.
Result<std::vector<ColorClassifier>> wandColors(const Project& project, const WandOptions& options);

/// What a calibration is doing. Return false to stop it.
struct WandWork {
  bool looking = true; ///< through the images; else solving
  std::int64_t done = 0;
  std::int64_t total = 0; ///< 0: unknown
  double rms = 0.0;       ///< pixels, while solving
};
using WandWorkCallback = std::function<bool(const WandWork&)>;

/// Calibrates from views that were collected, live or from a recording: the same bits from the
/// command line and from the window. The project itself is not changed. Faults that explain the
/// views better are named in the result, or in the error.
Result<WandResult> calibrateFromViews(const Project& project,
                                      const std::vector<std::vector<MarkerObservation>>& views,
                                      const WandOptions& options,
                                      const WandWorkCallback& callback = nullptr);

/// Looks through a recording for the project's balls and calibrates from them.
Result<WandResult> calibrateFromRecording(const Project& project, FrameSetSource& source,
                                          const WandOptions& options,
                                          const WandWorkCallback& callback = nullptr);

} // namespace dewpoint::setup
