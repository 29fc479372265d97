// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace dewpoint::app {

/// Name on the command line of the scene in which a board is shown to cameras.
inline constexpr const char* kBoardScene = "board";

/// Writes two recordings for calibration: a person lays a chessboard (9x6 inner corners, 25 mm) on
/// the floor, then shows it to both cameras from all sides and holds it still at each position.
/// Writes left.mkv and right.mkv (640x480, 15 per second), and truth.toml with the true cameras.
/// `frames`: maximum number of frames. `option`: name of the option that gives the folder, for
/// errors. Returns the exit code.
int recordBoard(const std::filesystem::path& folder, std::optional<std::int64_t> frames,
                const std::string& option);

} // namespace dewpoint::app
