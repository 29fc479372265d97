// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/wand/wand_calibration.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Case of the study of wand calibration: how wrong the camera poses are before the calibration,
/// and whether the cameras are synchronized.
enum class WandCase {
  Near,     ///< every camera is off by 10 cm and 3 degrees
  Far,      ///< every camera is off by 30 cm and 10 degrees
  Unsynced, ///< like Near, with every clock off by up to 16 ms
  /// Like Near, but with one ball, whose diameter determines the scale; the study requires no
  /// accuracy in this case.
  OneBall,
};

/// Properties of the simulated recording of the wand.
struct WandRecording {
  double framesPerSecond = 15.0;
  int jpegQuality = 0; ///< 1 to 100: images are compressed as JPEG; 0: no compression
};

/// Results of one calibration in the simulated hall. Lengths are in meters.
struct WandTrial {
  std::uint64_t seed = 0;
  WandCase kind = WandCase::Near;
  std::string failureReason; ///< error message if the calibration failed; otherwise empty
  double cameraPositionRms =
      0.0; ///< RMS error of the camera positions, after the best rigid alignment
  double ballPositionRms = 0.0; ///< RMS error of the ball positions, with the same alignment
  double scaleError = 0.0;      ///< relative error of the scale of the calibrated rig
  double clockOffsetError =
      0.0; ///< largest clock offset error relative to the first camera, seconds
  double medianReprojectionErrorPx =
      0.0; ///< median distance of ball images from their predicted positions, pixels
  double solveSeconds = 0.0; ///< duration of the calibration without the search for balls
  std::size_t viewCount = 0; ///< number of ball images that were detected
  bool hasPassed = false;    ///< true if the requirement of the case is met
};

/// Runs all cases of the study for one seed and returns one trial per case. Each trial calibrates
/// the four VGA cameras of the hall from rendered images of a wand with two balls (OneBall: one
/// ball). The balls are detected by color, with the same code that tracking uses. The recording
/// lasts 30 seconds. `report` receives each trial when it is finished, and returns false to stop.
std::vector<WandTrial> studyWand(std::uint64_t seed, const WandRecording& recording,
                                 const std::function<bool(const WandTrial&)>& report);

/// Returns the largest value of `cameraPositionRms` and `ballPositionRms` that the requirement of a
/// case allows, meters. Returns infinity if the study requires no accuracy in this case.
double wandRmsLimit(WandCase kind);
/// Returns the name of a case in reports.
std::string wandCaseName(WandCase kind);

} // namespace dewpoint::experiment
