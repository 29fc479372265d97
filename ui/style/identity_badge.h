// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QColor>
#include <QPointF>
#include <QRectF>

class QPainter;

namespace dewpoint::ui {

/// Returns the color of a person's identity.
QColor personColor(int identity);
/// Returns black or white, whichever is readable on this background.
QColor readableColorOn(const QColor& ground);

/// Draws a person's number in a round badge above `foot` and within `room`, on the identity color.
void paintBadge(QPainter& painter, int identity, const QPointF& foot, const QRectF& room,
                bool chosen);

} // namespace dewpoint::ui
