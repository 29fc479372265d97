// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/hold_state.h"

#include <QColor>
#include <QPalette>

#include <string>

namespace dewpoint::ui {

/// Returns the dark or light variant of the window palette for Qt's Fusion style.
QPalette themePalette(bool dark);
/// Returns whether a palette has dark colors.
bool isDarkPalette(const QPalette& palette);
/// Applies the style, palette and tooltip colors to the whole application, dark or light.
void applyTheme(bool dark);
/// Returns whether the application still has the palette set by `applyTheme()`.
bool isThemeApplied();

/// Returns the color of a target state, readable on the given palette. `holdText()` (ui/text)
/// returns the words.
QColor holdColor(HoldState state, const QPalette& palette);
/// Returns a color by index from `displayPalette()` for images, for targets without a learned
/// color. `targetColors()` (ui/style/target_colors.h) returns the colors in which the views draw
/// targets.
QColor targetColor(int target);
/// Returns the same, or the identity color if `name` is the name of a person.
QColor targetColor(const std::string& name, int target);

} // namespace dewpoint::ui
