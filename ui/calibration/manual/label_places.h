// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QLineF>
#include <QRectF>

#include <optional>
#include <vector>

namespace dewpoint::ui {

/// Finds places for labels beside points of an image, so that no label covers its point, a line or
/// another label. All coordinates are widget coordinates.
class LabelPlacer {
public:
  /// Creates an object for labels inside `area`.
  explicit LabelPlacer(const QRectF& area) : area_(area) {}

  /// Adds a line that labels must not cover.
  void avoid(const QLineF& line) { lines_.push_back(line); }
  /// Finds a place beside `point` for a label of this size, reserves the place, and returns it. Of
  /// the eight directions around the point, takes the one closest to `outward` that has room.
  /// Returns nothing if no direction has room, or if the point is outside the area.
  std::optional<QRectF> reservePlace(QPointF point, QSizeF size, QPointF outward);
  /// Finds a place like reservePlace(), for a label that must not be left out: if there is no other
  /// room, the label may cover a line.
  std::optional<QRectF> reservePlaceOverLines(QPointF point, QSizeF size, QPointF outward);
  /// Finds a place like reservePlace(), for a label that may be left out: tries only the direction
  /// `outward`.
  std::optional<QRectF> reservePlaceInDirection(QPointF point, QSizeF size, QPointF outward);

private:
  /// Returns the rectangle of a label in the direction `angle`, radians.
  static QRectF boxBeside(QPointF point, QSizeF size, double angle);
  std::optional<QRectF> find(QPointF point, QSizeF size, QPointF outward, bool mayCoverLines) const;
  std::optional<QRectF> reserved(const std::optional<QRectF>& box);
  bool isFree(const QRectF& box, bool mayCoverLines) const;

  QRectF area_;
  std::vector<QLineF> lines_;
  std::vector<QRectF> taken_;
};

} // namespace dewpoint::ui
