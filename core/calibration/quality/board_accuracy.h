// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/extrinsics_from_board.h"
#include "core/calibration/quality/calibration_accuracy.h"
#include "core/calibration/quality/fault_finder.h"

#include <cstdint>
#include <optional>

namespace dewpoint::calibration {

/// The accuracy of poses from a board (assessCalibration). Size: as well as a ruler shows the
/// board's longer side, 0.2 mm. Up, where the board lay on the floor at `worldInstant`: from the
/// corners' noise at that instant and a floor (or board) that is flat to 0.5 mm. Errors: those of
/// assessCalibration().
Result<CalibrationAccuracy> assessBoard(const ExtrinsicsResult& result,
                                        const BoardDescription& board,
                                        std::optional<std::int64_t> worldInstant);

/// Searches for faults in the views of the board (findFaults). The request's cameras have their
/// poses from before the calibration. If the views do not fit that rig at all, or it is no rig, it
/// counts as unknown: then `result` (null: there is none) is used instead, and lengths cannot be
/// checked. With fewer than two cameras that have views, there is no search.
FaultReport findBoardFaults(const ExtrinsicsRequest& request, double framesPerSecond,
                            const ExtrinsicsResult* result);

} // namespace dewpoint::calibration
