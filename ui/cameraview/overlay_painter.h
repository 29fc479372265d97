// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QColor>
#include <QPointF>

class QPainter;

namespace dewpoint::session {
struct CameraOverlay;
} // namespace dewpoint::session

namespace dewpoint::ui {

/// Where an image lies in its widget: its upper left corner, and widget units per image pixel.
struct ImagePlacement {
  QPointF corner;
  double scale = 1.0;
};

/// Draws what one camera would see of a target: thin bright strokes with a dark halo, readable on
/// any image.
void paintOverlay(QPainter& painter, const CameraOverlay& overlay, const ImagePlacement& placement,
                  const QColor& color);

} // namespace dewpoint::ui
