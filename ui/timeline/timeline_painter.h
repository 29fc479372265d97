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

/// Positions of the rows in a timeline, in widget coordinates.
struct TimelineRows {
  /// Computes the positions. `hasFooter` is true if there is a line of text below the rows.
  /// `gutter` is the width on the left for the names, and `fontHeight` the height of a line of
  /// text, in pixels.
  explicit TimelineRows(const QSizeF& size, int targetCount, int cameraCount, double fontHeight,
                        double gutter, bool hasFooter);
  /// Returns the height at which the rows of a timeline are readable. The height does not increase
  /// further beyond a few targets.
  static int minimumHeightFor(int targetCount, int cameraCount, double fontHeight);

  QRectF axisArea;    ///< time and markers, at the top; a drag here selects a range
  QRectF ribbonsArea; ///< rows of the targets, one below the other
  /// Missing images: one thin row per affected camera, or a single row if there is not enough room.
  QRectF camerasArea;
  QRectF footerArea; ///< progress while frames are tracked again; otherwise, its height is 0
  double ribbonHeight = 0.0;
  double cameraRowHeight = 0.0;
  bool camerasShareRow = false;
  QRectF ribbonArea(int target) const;
  QRectF cameraRowArea(int row) const;
};

/// Draws a timeline: the ribbons (bands that show the states of the targets), missing images,
/// markers, the selected range, the current frame, and a thin line at the frame under the pointer
/// (`hovered`; negative for none). In a ribbon, the state held (confirmed by the cameras) is a thin
/// line, ambiguous is dotted, searching is hatched, and lost is crossed. Results of earlier
/// settings are pale.
void paintTimeline(QPainter& painter, const TimelineModel& model, const TimelineScale& scale,
                   const TimelineRows& rows, const Selection& selection, qint64 hovered,
                   const QPalette& palette);

/// Returns the area of the flag that shows a marker, in widget coordinates.
QRectF markerFlagArea(const ProjectMarker& marker, const TimelineScale& scale,
                      const TimelineRows& rows, const QFontMetricsF& metrics);

} // namespace dewpoint::ui
