// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/target_colors.h"

#include <QColor>
#include <QPalette>

#include <vector>

namespace dewpoint::ui {

/// Returns the ground of views and lists in a window with this palette.
DisplayGround displayGround(const QPalette& palette);
/// Returns the colors in which all views draw these targets: in every view the same hue, in a shade
/// that is legible on its ground.
std::vector<QColor> targetColors(const std::vector<DisplayColorSource>& sources,
                                 DisplayGround ground);

} // namespace dewpoint::ui
