// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/extrinsics_from_board.h"
#include "core/calibration/quality/calibration_accuracy.h"
#include "core/calibration/quality/fault_finder.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace dewpoint::calibration {

/// Returns the accuracy of poses estimated from a board (assessCalibration()). The error of the
/// scale is assumed to come from measuring the longer side of the board with a ruler to 0.2 mm. If
/// the board lay on the floor at `worldDefiningInstant`, the accuracy of the upward direction is
/// derived from the noise of the corners at that instant, assuming that the floor and the board are
/// flat to 0.5 mm.
///
/// `lenses` has one entry for each camera of `result.problem`: its intrinsics if they were
/// estimated from the same recording, otherwise null. Errors of such intrinsics are included in the
/// accuracy. Errors: those of assessCalibration().
Result<CalibrationAccuracy> assessBoard(const ExtrinsicsResult& result,
                                        const BoardDescription& board,
                                        std::optional<std::int64_t> worldDefiningInstant,
                                        const std::vector<const IntrinsicsResult*>& lenses = {});

/// Replaces the standard deviations of the camera poses in `result` by those in `accuracy`. Cameras
/// are matched by name.
void setCameraSigmas(const CalibrationAccuracy& accuracy, ExtrinsicsResult& result);

/// Searches for faults in the views of the board (findFaults()). The cameras in `request` have the
/// poses from before the calibration. If these poses do not form a valid rig, or if the views do
/// not fit them at all, they are treated as unknown. The search then uses the poses of `result`
/// instead, and cannot check lengths. `result` may be null if there is none. No search takes place
/// if fewer than two cameras have views, or if the board is symmetric and there is no result.
FaultReport findBoardFaults(const ExtrinsicsRequest& request, double framesPerSecond,
                            const ExtrinsicsResult* result);

} // namespace dewpoint::calibration
