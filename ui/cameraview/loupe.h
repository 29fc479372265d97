// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QPointF>
#include <QRectF>
#include <QSizeF>

class QPainter;

namespace cv {
class Mat;
}

namespace dewpoint::ui {

/// Returns the rectangle for a magnifier next to the pointer in a widget of size `room`. The
/// rectangle is never under the pointer or outside the widget. It is empty if there is not enough
/// room.
QRectF loupeRect(const QPointF& pointer, const QSizeF& room);

/// Draws a round magnifier at `place` with the enlarged image around `pixel`, and a cross at the
/// pixel `meant` that a click would pick. Pixel centers lie at integer coordinates. `image` is
/// CV_8UC3.
void paintLoupe(QPainter& painter, const QRectF& place, const cv::Mat& image, const QPointF& pixel,
                const QPointF& meant);

} // namespace dewpoint::ui
