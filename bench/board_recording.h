// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/camera.h"
#include "core/setup/calibration/board_search.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace dewpoint::bench {

/// Board as several cameras saw it, and what a calibration from it starts from.
struct BoardRecording {
  std::string name;
  Project project; ///< cameras without poses
  setup::BoardDetections seen;
  BoardDescription board;
  CameraRig truth;          ///< true cameras of a simulated rig; otherwise empty
  bool lensesKnown = false; ///< true if the project contains the intrinsics of the cameras
};

/// Simulates a board that is waved for 12 s in front of two to five cameras (five images per
/// second, 640 x 480). The board is bent by half a millimeter. The exposure times of two thirds of
/// the rigs scatter by up to 5 or 15 ms, like those of webcams. The distortion of the lenses has
/// more coefficients than the model that is estimated. If `rendered` is true, images with noise and
/// blur are rendered and searched for the board, which takes much longer; it is flat then.
/// Otherwise its corners are projected, with noise as in such images.
BoardRecording simulatedRig(std::uint64_t seed, bool rendered);

/// Detects the board in the recording `charuco4`, with the published lenses.
Result<BoardRecording> charucoRecording(const std::filesystem::path& data);

/// Detects the board in the pairs of images of `stereo_tray`.
Result<BoardRecording> trayRecording(const std::filesystem::path& data);

} // namespace dewpoint::bench
