// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/wand/wand_calibration.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Error of the initial rig, and whether the cameras are synchronized.
enum class WandCase {
  Near,     ///< every camera 10 cm and 3 degrees off
  Far,      ///< 30 cm and 10 degrees
  Unsynced, ///< as Near, with every clock up to 16 ms off
  OneBall,  ///< as Near, with one ball; scale from its diameter; no bar
};

/// Properties of the recording.
struct WandRecording {
  double framesPerSecond = 15.0;
  int jpegQuality = 0; ///< 1 to 100: images are compressed as JPEG; 0: they are not
};

/// Results of one calibration of the simulated hall. Lengths in meters.
struct WandTrial {
  std::uint64_t seed = 0;
  WandCase kind = WandCase::Near;
  std::string failure;      ///< error message if the calibration failed
  double cameraRms = 0.0;   ///< camera positions, after the best rigid alignment
  double pointRms = 0.0;    ///< positions of the balls, under the same alignment
  double scaleError = 0.0;  ///< relative
  double offsetError = 0.0; ///< largest, seconds; relative to the first camera
  double medianPx = 0.0;
  double solveSeconds = 0.0;
  std::size_t views = 0;
  bool passed = false; ///< within the bar of its case
};

/// Calibrates the hall's four VGA cameras from rendered images of a wand with two balls, detected
/// with the color code of tracking: all cases for one seed. `report` receives each trial when it is
/// done; it returns false to stop. The recording has 30 seconds with `framesPerSecond` images per
/// second.
std::vector<WandTrial> studyWand(std::uint64_t seed, const WandRecording& recording,
                                 const std::function<bool(const WandTrial&)>& report);

/// Bar of a case: largest RMS of cameras and points, meters; infinite if there is none.
double wandBar(WandCase kind);
std::string wandCaseName(WandCase kind);

} // namespace dewpoint::experiment
