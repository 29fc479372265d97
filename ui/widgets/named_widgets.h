// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QIcon>
#include <QLatin1String>
#include <QPixmap>
#include <QPushButton>

namespace dewpoint::ui {

/// Creates a button with this object name and without a text. The caller sets its text in the
/// current language.
inline QPushButton* makeButton(const char* name, QWidget* parent) {
  auto* button = new QPushButton(parent);
  button->setObjectName(QLatin1String(name));
  return button;
}

/// Returns a square single-color icon for lists. `size` is in pixels.
inline QIcon makeColorChip(const QColor& color, int size) {
  QPixmap pixmap(size, size);
  pixmap.fill(color);
  return {pixmap};
}

} // namespace dewpoint::ui
