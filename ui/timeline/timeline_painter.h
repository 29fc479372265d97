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

/// Positions of the rows of a timeline, in widget coordinates.
struct TimelineRows {
  explicit TimelineRows(const QSizeF& size, int targets, int cameras, double fontHeight,
                        double gutter);
  /// Height in which these rows are readable; it does not grow beyond a few targets.
  static int leastHeight(int targets, int cameras, double fontHeight);

  QRectF axis;    ///< time and markers, at the top; a drag here selects a range
  QRectF ribbons; ///< of the targets, one below the other
  /// missing images: one thin row per affected camera, or one row for all without enough room
  QRectF cameras;
  QRectF footer; ///< frames kept in memory
  double ribbonHeight = 0.0;
  double cameraHeight = 0.0;
  bool camerasShareRow = false;
  QRectF ribbon(int target) const;
  QRectF camera(int row) const;
};

/// Draws a timeline: ribbons (held: a thin line; ambiguous: dotted; searching: hatched; lost:
/// crossed; results of earlier settings: pale), missing images, markers, the range, the play head,
/// and a thin line at the frame under the pointer (`hovered`; negative: none).
void paintTimeline(QPainter& painter, const TimelineModel& model, const TimelineScale& scale,
                   const TimelineRows& rows, const Selection& selection, qint64 hovered,
                   const QPalette& palette);

/// Area of the flag of a marker in the widget.
QRectF markerFlag(const ProjectMarker& marker, const TimelineScale& scale, const TimelineRows& rows,
                  const QFontMetricsF& metrics);

} // namespace dewpoint::ui
