// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board.h"
#include "core/capture/frame.h"
#include "core/capture/frame_source.h"
#include "core/project/project.h"

#include <cstddef>
#include <cstdint>

namespace dewpoint::setup {

/// Project whose floor and origin were set from a board that lies on the floor.
struct FloorFromBoard {
  Project project;
  double rotationAngle = 0.0;  ///< angle of the rotation of the world, radians
  double rmsPx = 0.0;          ///< root mean square error of the board's corners, pixels
  std::size_t cameraCount = 0; ///< number of cameras that see the board
};

/// Sets the world frame of calibrated cameras from images that show a board lying flat on the
/// floor. The first corner of the board becomes the origin; x runs along the rows of the board, y
/// toward its upper edge, and z up (worldFromFlatBoard()). The cameras keep their positions
/// relative to each other. Everything else in the project that has world coordinates is moved with
/// the cameras (withMovedWorld()). One camera that sees the board is enough; more cameras make the
/// floor more accurate.
///
/// `frames` contains one image per camera of the project, all taken at the same time. An entry is
/// null if there is no image. Errors: those of locateBoardInRig(), and Mismatch if an image does
/// not have the size that its camera is calibrated for.
Result<FloorFromBoard> withFloorFromBoard(const Project& project, const BoardDescription& board,
                                          const FrameSet& frames);

/// Sets the world frame from a board that lies on the floor in frame `frame` (from 0) of a
/// recording. Returns BadValue if the recording has no such frame, Mismatch if an image does not
/// have the size that its camera is calibrated for, and the errors of locateBoardInRig() and of the
/// source.
Result<FloorFromBoard> withFloorFromBoard(const Project& project, const BoardDescription& board,
                                          FrameSetSource& source, std::int64_t frame);

} // namespace dewpoint::setup
