// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/hold_state.h"

#include <QColor>
#include <QPalette>

#include <string>

namespace dewpoint::ui {

/// Returns the palette of the window, in its dark or light variant, for the Fusion style of Qt.
QPalette themePalette(bool dark);
/// Whether a palette has dark colors.
bool isDarkPalette(const QPalette& palette);
/// Applies the style, palette and tooltip colors to the whole application, dark or light.
void applyTheme(bool dark);
/// Whether the palette set by `applyTheme()` is still that of the application.
bool isThemeApplied();

/// Returns the color of a state, readable on the given palette; `holdText()` (ui/text) returns the
/// words.
QColor holdColor(HoldState state, const QPalette& palette);
/// Returns the color of a target by index (Okabe-Ito), for strokes on images and on a dark
/// background.
QColor targetColor(int target);
/// Returns the color of a target of the project. A person has the color of the identity in all
/// views.
QColor targetColor(const std::string& name, int target);

} // namespace dewpoint::ui
