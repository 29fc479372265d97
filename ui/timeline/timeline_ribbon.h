// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/timeline/timeline_model.h"
#include "ui/timeline/timeline_scale.h"

#include <QPalette>
#include <QRectF>

class QPainter;

namespace dewpoint::ui {

/// Draws a target's ribbon: its state over time, in its row. The state held (confirmed by the
/// cameras) is inconspicuous: a thin line that becomes thicker as the existence probability
/// decreases. Other states fill the row (ambiguous: dotted; searching: hatched; lost: crossed).
void paintRibbon(QPainter& painter, const TimelineModel& model, const TimelineScale& scale,
                 const QRectF& row, std::size_t target, const QPalette& palette);

/// Draws a text in place of the ribbons (the bands that show the target states) while nothing is
/// tracked. The text explains what will appear there.
void paintNothingTrackedText(QPainter& painter, const QRectF& rows, const QPalette& palette);

} // namespace dewpoint::ui
