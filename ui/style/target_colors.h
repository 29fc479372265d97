// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/view/target_colors.h"

#include <QColor>
#include <QPalette>

#include <vector>

namespace dewpoint::ui {

/// Returns the ground (light or dark) on which views and lists draw targets in a window with this
/// palette.
DisplayBackground displayGroundOf(const QPalette& palette);
/// Returns the colors in which views with this ground draw the targets. A target has the same hue
/// on every ground, in a shade that is legible there.
std::vector<QColor> targetColors(const std::vector<DisplayColorSource>& sources,
                                 DisplayBackground ground);

} // namespace dewpoint::ui
