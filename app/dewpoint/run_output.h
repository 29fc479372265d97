// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <filesystem>

namespace dewpoint::ui {
class MainWindow;
} // namespace dewpoint::ui

namespace dewpoint::app {

/// `dewpoint --out DIR`: leaves trajectory.csv and run.json in a folder whenever the recording was
/// tracked to its end, and when the application quits.
void writeRunTo(MainWindow& window, const std::filesystem::path& folder);

} // namespace dewpoint::app
