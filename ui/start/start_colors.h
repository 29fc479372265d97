// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/style/mixed_color.h"

#include <QColor>
#include <QPalette>

namespace dewpoint::ui {

/// Returns the color for the line below a title: fainter than normal text, but still easy to read
/// on cards and in lists.
inline QColor secondaryTextColor(const QPalette& palette) {
  return mixedColor(palette.color(QPalette::Text), palette.color(QPalette::Base), 0.3);
}

} // namespace dewpoint::ui
