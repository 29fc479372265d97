// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_coverage.h"
#include "core/calibration/wand/wand_calibration.h"

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// Content of the report page of a calibration by wand.
struct WandReport {
  CameraRig before;                    ///< the initial rig
  WandResult result;                   ///< including its faults
  std::string accuracy;                ///< one sentence
  std::vector<BoardCoverage> coverage; ///< per camera
  bool offsetsFound = false;           ///< whether time offsets were estimated
};

/// Report as one self-contained HTML page: accuracy, faults and results, residual arrows and
/// coverage for each camera, and cameras and the target's path in space.
std::string htmlText(const WandReport& report);

} // namespace dewpoint::calibration
