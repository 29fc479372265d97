// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/timeline/timeline_model.h"
#include "ui/timeline/timeline_scale.h"

#include <QPalette>
#include <QRectF>

class QPainter;

namespace dewpoint::ui {

/// Draws along its row how a target was held: held is quiet, a thin line that grows as the
/// existence falls; trouble fills the row (ambiguous: dotted; searching: hatched; lost: crossed).
void paintRibbon(QPainter& painter, const TimelineModel& model, const TimelineScale& scale,
                 const QRectF& row, std::size_t target, const QPalette& palette);

/// Says what will be there, as long as there is no ribbon.
void paintNothingTracked(QPainter& painter, const QRectF& rows, const QPalette& palette);

} // namespace dewpoint::ui
