// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/scene_palette.h"

#include <QColor>

namespace dewpoint::ui {

/// Converts a scene color to a QColor.
inline QColor toQColor(const SceneColor& color) {
  return QColor::fromRgbF(float(color.x()), float(color.y()), float(color.z()));
}

} // namespace dewpoint::ui
