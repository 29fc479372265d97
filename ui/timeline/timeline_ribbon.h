// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/timeline/timeline_model.h"
#include "ui/timeline/timeline_scale.h"

#include <QPalette>
#include <QRectF>

class QPainter;

namespace dewpoint::ui {

/// Draws the state of a target over time in its row. Held is inconspicuous: a thin line that
/// thickens as the existence probability decreases. Other states fill the row (ambiguous: dotted;
/// searching: hatched; lost: crossed).
void paintRibbon(QPainter& painter, const TimelineModel& model, const TimelineScale& scale,
                 const QRectF& row, std::size_t target, const QPalette& palette);

/// Draws a text that explains what will appear here, while there is no ribbon.
void paintNothingTracked(QPainter& painter, const QRectF& rows, const QPalette& palette);

} // namespace dewpoint::ui
