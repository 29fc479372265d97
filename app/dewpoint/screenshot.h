// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

namespace dewpoint::ui {
class MainWindow;
} // namespace dewpoint::ui

namespace dewpoint::app {

/// Once `frames` frames were tracked, saves the whole window as a PNG, prints its path and ends the
/// application: 0 if all went well, 1 with a sentence on stderr if not.
void takeScreenshot(MainWindow& window, const QString& file, int frames);

} // namespace dewpoint::app
