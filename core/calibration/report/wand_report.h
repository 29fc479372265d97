// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_coverage.h"
#include "core/calibration/wand/wand_calibration.h"

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Content of the report page for a calibration by wand.
struct WandReport {
  CameraRig initialRig;                  ///< initial rig
  WandResult result;                     ///< result of the calibration, including its faults
  std::string accuracyText;              ///< text about the accuracy
  std::vector<BoardCoverage> coverage;   ///< image regions in which the ball was seen, per camera
  bool hasTimeOffsets = false;           ///< true if time offsets were estimated
  std::vector<std::string> notices = {}; ///< sentences about missing motion
};

/// Returns the report as a self-contained HTML page. It shows accuracy, faults and results,
/// residual arrows and coverage for each camera, and the cameras and the target's path in space.
std::string htmlText(const WandReport& report);

} // namespace dewpoint::calibration
