// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/view/target_colors.h"

#include <QColor>
#include <QPalette>

#include <vector>

namespace dewpoint::ui {

/// Returns the background (light or dark) on which views and lists draw targets in a window with
/// this palette.
DisplayBackground displayBackgroundOf(const QPalette& palette);
/// Returns the colors in which views with this background (light or dark) draw the targets. A
/// target has the same hue on every background, in a shade that is legible there.
std::vector<QColor> targetColors(const std::vector<DisplayColorSource>& sources,
                                 DisplayBackground ground);

} // namespace dewpoint::ui
