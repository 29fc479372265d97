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

/// Looks for faults in where the board was seen (findFaults). The request's cameras stand where
/// they stood before. Where what is seen does not fit that rig at all, or it is no rig, it was not
/// known; then `result` (null: there is none) takes its place, and lengths cannot be judged. With
/// fewer than two cameras that have views, nothing is looked for.
FaultReport findBoardFaults(const ExtrinsicsRequest& request, double framesPerSecond,
                            const ExtrinsicsResult* result);

} // namespace dewpoint::calibration
