// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/selection/selection.h"
#include "ui/timeline/timeline_model.h"
#include "ui/timeline/timeline_scale.h"

#include <QFontMetricsF>
#include <QPalette>
#include <QRectF>

class QPainter;

namespace dewpoint::ui {

/// Where the rows of a timeline lie, in the units of the widget.
struct TimelineRows {
  explicit TimelineRows(const QSizeF& size, int targets, int cameras, double fontHeight,
                        double gutter);
  /// The height in which these rows can be read; of more than a few targets it wants no more.
  static int leastHeight(int targets, int cameras, double fontHeight);

  QRectF axis;    ///< time and markers, at the top; dragging here selects a range
  QRectF ribbons; ///< of the targets, one below the other
  QRectF cameras; ///< drop-outs, one thin row per camera that has any; one for all in little room
  QRectF footer;  ///< memory of the history
  double ribbonHeight = 0.0;
  double cameraHeight = 0.0;
  bool camerasShareRow = false;
  QRectF ribbon(int target) const;
  QRectF camera(int row) const;
};

/// Draws a timeline: ribbons (held: a thin line; ambiguous: dotted; searching: hatched; lost:
/// crossed; of earlier settings: pale), drop-outs, markers, the range, the play head, and a thin
/// line where the pointer is
/// (`hovered`, a frame; negative: none).
void paintTimeline(QPainter& painter, const TimelineModel& model, const TimelineScale& scale,
                   const TimelineRows& rows, const Selection& selection, qint64 hovered,
                   const QPalette& palette);

/// The part of the widget that a marker's flag takes.
QRectF markerFlag(const ProjectMarker& marker, const TimelineScale& scale, const TimelineRows& rows,
                  const QFontMetricsF& metrics);

} // namespace dewpoint::ui
