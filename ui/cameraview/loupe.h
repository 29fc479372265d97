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

/// Returns where to place a magnifier next to the pointer in a widget of size `room`. It never lies
/// under the pointer or outside the widget. Returns an empty rectangle if there is not enough room.
QRectF loupeRect(const QPointF& pointer, const QSizeF& room);

/// Draws the enlarged image around `pixel` into a round magnifier at `place`, with a cross at the
/// pixel `meant`. Pixel centers lie at integer coordinates. `image` is CV_8UC3.
void paintLoupe(QPainter& painter, const QRectF& place, const cv::Mat& image, const QPointF& pixel,
                const QPointF& meant);

} // namespace dewpoint::ui
