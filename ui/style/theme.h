// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/tracking_state.h"

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

/// Returns the color of a target state, readable on the given palette. `trackingStateText()`
/// (ui/text) returns the text of the state.
QColor trackingStateColor(TrackingState state, const QPalette& palette);
/// Returns the color over images of a target without a learned color: the entry of
/// `displayPalette()` for the index `target`. `targetColors()` (ui/style/target_colors.h) returns
/// the colors in which the views draw targets.
QColor targetColor(int target);
/// Returns the color of a target: the identity color if `name` is the name of a person; otherwise,
/// the palette color for the index `target`.
QColor targetColor(const std::string& name, int target);

} // namespace dewpoint::ui
