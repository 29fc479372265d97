// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/calibration/wand/wand_calibration.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// How far the initial rig is off, and whether the cameras keep the same time.
enum class WandCase {
  Near,     ///< every camera 10 cm and 3 degrees off
  Far,      ///< 30 cm and 10 degrees
  Unsynced, ///< as Near, and every clock up to 16 ms off
  OneBall,  ///< as Near, with one ball, the size from its diameter; no bar
};

/// What is recorded.
struct WandRecording {
  double framesPerSecond = 15.0;
  int jpegQuality = 0; ///< 1 to 100: images go through JPEG; 0: they do not
};

/// The figures of one calibration of the simulated hall. Lengths in meters.
struct WandTrial {
  std::uint64_t seed = 0;
  WandCase kind = WandCase::Near;
  std::string failure;      ///< the sentence, when nothing came out
  double cameraRms = 0.0;   ///< of the cameras' positions, after the best rigid motion of both
  double pointRms = 0.0;    ///< of the balls' positions, under the same motion
  double scaleError = 0.0;  ///< relative
  double offsetError = 0.0; ///< largest, seconds; against the first camera
  double medianPx = 0.0;
  double solveSeconds = 0.0;
  std::size_t views = 0;
  bool passed = false; ///< within the bar of its case
};

/// Calibrations of the hall's four VGA cameras from rendered images of a wand with two balls, seen
/// through the color code that tracking uses: for one seed, all cases. `report` gets each trial as
/// it is done; it returns false to stop. 30 seconds, `framesPerSecond` images per second.
std::vector<WandTrial> studyWand(std::uint64_t seed, const WandRecording& recording,
                                 const std::function<bool(const WandTrial&)>& report);

/// The bar of a case: largest RMS of cameras and points, meters; infinite where there is none.
double wandBar(WandCase kind);
std::string wandCaseName(WandCase kind);

} // namespace dewpoint::experiment
