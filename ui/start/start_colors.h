// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/style/mixed_color.h"

#include <QColor>
#include <QPalette>

namespace dewpoint::ui {

/// Of the line below a title: quieter than the text, and still read with ease on cards and lists.
inline QColor secondaryText(const QPalette& palette) {
  return mixedColor(palette.color(QPalette::Text), palette.color(QPalette::Base), 0.3);
}

} // namespace dewpoint::ui
