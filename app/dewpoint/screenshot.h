// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

namespace dewpoint::ui {
class MainWindow;
} // namespace dewpoint::ui

namespace dewpoint::app {

/// Saves the whole window as a PNG once `frames` frames are tracked, prints its path and ends the
/// application. The exit code is 0 on success; on failure it is 1, with a sentence on stderr.
void takeScreenshot(MainWindow& window, const QString& file, int frames);

} // namespace dewpoint::app
