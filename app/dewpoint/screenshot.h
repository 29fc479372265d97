// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

namespace dewpoint::ui {
class MainWindow;
} // namespace dewpoint::ui

namespace dewpoint::app {

/// Saves an image of the whole window as a PNG file once `frames` frames are tracked, prints the
/// path of the file, and ends the application. The exit code is 0 on success, and 1 on failure,
/// with a sentence on stderr.
void takeScreenshot(MainWindow& window, const QString& file, int frames);

} // namespace dewpoint::app
