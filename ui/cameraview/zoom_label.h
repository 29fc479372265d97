// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

class QPainter;
class QRectF;

namespace dewpoint::ui {

/// Draws the magnification (`scale`, widget units per image pixel) as text in the lower right
/// corner of an image, and returns the area of this text.
QRectF paintZoomLabel(QPainter& painter, const QRectF& area, double scale);

} // namespace dewpoint::ui
