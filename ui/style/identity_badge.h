// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QColor>
#include <QPointF>
#include <QRectF>

class QPainter;

namespace dewpoint::ui {

/// The color of a person's identity.
QColor personColor(int identity);
/// Black or white, whichever reads on this ground.
QColor inkOn(const QColor& ground);

/// The number of a person on the color of its identity, in a round badge above `foot`, within
/// `room`.
void paintBadge(QPainter& painter, int identity, const QPointF& foot, const QRectF& room,
                bool chosen);

} // namespace dewpoint::ui
