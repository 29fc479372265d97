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

/// Where a loupe lies beside the pointer in a widget of this size: never under the pointer nor
/// beyond the border. Empty where there is no room for one.
QRectF loupePlace(const QPointF& pointer, const QSizeF& room);

/// Draws the image around a pixel (centers at whole numbers), enlarged, into a round loupe at that
/// place, and a cross at the pixel that is `meant`. `image` is CV_8UC3.
void paintLoupe(QPainter& painter, const QRectF& place, const cv::Mat& image, const QPointF& pixel,
                const QPointF& meant);

} // namespace dewpoint::ui
