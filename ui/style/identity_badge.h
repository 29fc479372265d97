// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QColor>
#include <QPointF>
#include <QRectF>

class QPainter;

namespace dewpoint::ui {

/// Returns the color in which views draw the person with this identity.
QColor personColor(int identity);
/// Returns black or white, whichever is readable on this background.
QColor readableColorOn(const QColor& ground);

/// Draws a round badge in the identity color with the person's number, above the point `foot` and
/// inside the area `room`.
void paintIdentityBadge(QPainter& painter, int identity, const QPointF& foot, const QRectF& room,
                        bool chosen);

} // namespace dewpoint::ui
