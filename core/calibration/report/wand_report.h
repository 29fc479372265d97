// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_coverage.h"
#include "core/calibration/wand/wand_calibration.h"

#include <string>
#include <vector>

namespace dewpoint::calibration {

/// What the page about a calibration by wand shows.
struct WandReport {
  CameraRig before;                    ///< the initial rig
  WandResult result;                   ///< with its faults
  std::string accuracy;                ///< a sentence
  std::vector<BoardCoverage> coverage; ///< per camera
  bool offsetsFound = false;           ///< whether time offsets were estimated
};

/// One self-contained HTML page: the accuracy, faults and results, residual arrows and coverage for
/// each camera, and cameras and the target's way in space.
std::string htmlText(const WandReport& report);

} // namespace dewpoint::calibration
