// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace dewpoint::app {

/// Command-line name of the scene in which a board is shown to cameras.
inline constexpr const char* kBoardSceneName = "board";

/// Writes a simulated recording of a calibration with two cameras to a folder, and returns the exit
/// code. A person lays a chessboard (9x6 inner corners, squares of 25 mm) on the floor, then shows
/// it to both cameras from all sides and holds it still at each position. The files are left.mkv
/// and right.mkv (640x480 pixels, 15 frames per second), and truth.toml with the true cameras.
/// `frames` is the maximum number of frames. Error messages name `option`, the command-line option
/// that gives the folder.
int recordBoard(const std::filesystem::path& folder, std::optional<std::int64_t> frames,
                const std::string& option);

} // namespace dewpoint::app
