// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace dewpoint::app {

/// The scene in which a board is shown to cameras, by the name that the command line takes.
inline constexpr const char* kBoardScene = "board";

/// Writes two recordings to calibrate from: somebody lays a chessboard (9x6 inner corners, 25 mm)
/// on the floor, then shows it to both cameras from all sides and holds it still at each position.
/// left.mkv, right.mkv (640x480, 15 per second), and truth.toml with the true cameras. `frames`:
/// that many of them only. `option` is the one that names the folder. Returns the exit code.
int recordBoard(const std::filesystem::path& folder, std::optional<std::int64_t> frames,
                const std::string& option);

} // namespace dewpoint::app
