// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/hold_state.h"

#include <QColor>
#include <QPalette>

#include <string>

namespace dewpoint::ui {

/// The one palette of the window, in two tunings, on Qt's Fusion style.
QPalette themePalette(bool dark);
/// Whether the colors of a palette are dark ones.
bool isDarkPalette(const QPalette& palette);
/// Style, palette and tooltips of the whole application: dark or light.
void applyTheme(bool dark);
/// The palette that applyTheme() set is the application's, and nobody has set another one since.
bool isThemeApplied();

/// The color of a state that reads on the given palette; its words are holdText() (ui/text).
QColor holdColor(HoldState state, const QPalette& palette);
/// Okabe-Ito, by index of the target; for strokes on images and dark ground.
QColor targetColor(int target);
/// The same for targets of the project; persons have the color of their identity everywhere.
QColor targetColor(const std::string& name, int target);

} // namespace dewpoint::ui
