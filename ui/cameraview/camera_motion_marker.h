// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

class QPainter;
class QPalette;
class QRectF;

namespace dewpoint::ui {

/// Draws `text`, the reason why a live camera delivers no images, at the bottom of its last image.
/// Draws nothing if `text` is empty.
void paintCameraProblem(QPainter& painter, const QRectF& image, const QString& text,
                        const QPalette& palette);

/// Marks the image of a camera that has moved since it was calibrated. Draws a dashed frame, and
/// `text` in the upper left corner. Draws nothing if `text` is empty.
void paintCameraMotionMarker(QPainter& painter, const QRectF& image, const QString& text,
                             const QPalette& palette);

} // namespace dewpoint::ui
