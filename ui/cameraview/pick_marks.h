// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QPolygonF>
#include <QString>
#include <QStringList>

class QFontMetricsF;
class QPainter;
class QRectF;
class QSizeF;

namespace dewpoint::ui {

// Marks that picking tools draw over an image, in widget units. They are bright yellow with a dark
// halo.

/// Draws the outline of a region.
void paintPickOutline(QPainter& painter, const QPolygonF& outline, Qt::PenStyle style);
/// Draws the outline of a region with a label above it. The label stays within a widget of size
/// `room`.
void paintPickRegion(QPainter& painter, const QPolygonF& outline, const QString& text,
                     const QSizeF& room);
/// Draws a cross with an open center.
void paintPickCross(QPainter& painter, const QPointF& position);
/// Draws a thin guide line.
void paintPickGuide(QPainter& painter, const QPolygonF& line);
/// Splits a hint at its separators " · " into as few lines as possible, each at most `width` wide
/// if its parts allow this, and returns the lines.
QStringList pickHintLines(const QString& hint, const QFontMetricsF& metrics, double width);
/// Draws the hint that explains what a click does, at the lower edge of the area.
void paintPickHint(QPainter& painter, const QString& hint, const QRectF& area);

} // namespace dewpoint::ui
