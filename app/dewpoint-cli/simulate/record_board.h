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

/// Writes two recordings for calibration: a person lays a chessboard (9x6 inner corners, 25 mm) on
/// the floor, then shows it to both cameras from all sides and holds it still at each position.
/// Writes left.mkv and right.mkv (640x480 pixels, 15 frames per second), and truth.toml with the
/// true cameras. `frames` is the maximum number of frames. `option` is the command-line option that
/// gives the folder; errors name it. Returns the exit code.
int recordBoard(const std::filesystem::path& folder, std::optional<std::int64_t> frames,
                const std::string& option);

} // namespace dewpoint::app
