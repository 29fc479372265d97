// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

class QPainter;
class QPalette;
class QRectF;

namespace dewpoint::ui {

/// Marks the image of a camera that does not stand as it was calibrated: a dashed frame, and what
/// happened in its upper left corner. Nothing for an empty text.
void paintCameraMotionMarker(QPainter& painter, const QRectF& image, const QString& text,
                             const QPalette& palette);

} // namespace dewpoint::ui
