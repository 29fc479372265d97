// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QLineF>
#include <QRectF>

#include <optional>
#include <vector>

namespace dewpoint::ui {

/// Finds places for labels beside points of an image, so that no label covers its point, a line or
/// another label. All coordinates are of the widget.
class LabelPlaces {
public:
  /// Labels stay inside `area`.
  explicit LabelPlaces(const QRectF& area) : area_(area) {}

  /// Keeps labels away from a line.
  void avoid(const QLineF& line) { lines_.push_back(line); }
  /// Finds a place for a label of a size, and takes it: beside `point`, in the direction `outward`
  /// if there is room. Returns nothing if the point is outside the area, or if there is no room.
  /// The label never covers the point.
  std::optional<QRectF> take(QPointF point, QSizeF size, QPointF outward);
  /// The same for a label that is needed: it covers a line if there is no other room.
  std::optional<QRectF> takeNeeded(QPointF point, QSizeF size, QPointF outward);
  /// Takes the place of a label in this direction only, and only if it covers nothing. For labels
  /// that may be left out.
  std::optional<QRectF> takeIfFree(QPointF point, QSizeF size, QPointF outward);

private:
  /// Where a label lies in the direction `angle`, radians.
  static QRectF boxBeside(QPointF point, QSizeF size, double angle);
  std::optional<QRectF> find(QPointF point, QSizeF size, QPointF outward, bool mayCoverLines) const;
  std::optional<QRectF> taken(const std::optional<QRectF>& box);
  bool isFree(const QRectF& box, bool mayCoverLines) const;

  QRectF area_;
  std::vector<QLineF> lines_;
  std::vector<QRectF> taken_;
};

} // namespace dewpoint::ui
