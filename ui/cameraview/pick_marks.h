// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QPolygonF>
#include <QString>

class QPainter;
class QRectF;
class QSizeF;

namespace dewpoint::ui {

// What the tools that point at an image draw over it, in widget units: bright yellow with a dark
// halo.

/// The outline of a region.
void paintPickOutline(QPainter& painter, const QPolygonF& outline, Qt::PenStyle style);
/// The same with a word above it, within a widget of this size.
void paintPickRegion(QPainter& painter, const QPolygonF& outline, const QString& text,
                     const QSizeF& room);
/// A cross with an open middle.
void paintPickCross(QPainter& painter, const QPointF& position);
/// A thin line.
void paintPickGuide(QPainter& painter, const QPolygonF& line);
/// What a click is for, at the lower edge of the area.
void paintPickHint(QPainter& painter, const QString& hint, const QRectF& area);

} // namespace dewpoint::ui
