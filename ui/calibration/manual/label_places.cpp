// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/manual/label_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dewpoint::ui {
namespace {

constexpr double kPointLabelGap =
    7.0; ///< between a point and its label: the ring and the lines stay visible
/// Directions that are tried one after the other, in eighths of a rotation from the wanted one.
constexpr std::array kLabelDirections{0, 1, -1, 2, -2, 3, -3, 4};

/// Whether a segment has a part inside a box (Liang and Barsky 1984).
bool crossesBox(const QRectF& box, const QLineF& line) {
  const QPointF way = line.p2() - line.p1();
  const double delta[] = {-way.x(), way.x(), -way.y(), way.y()};
  const double room[] = {line.x1() - box.left(), box.right() - line.x1(), line.y1() - box.top(),
                         box.bottom() - line.y1()};
  double enter = 0.0;
  double leave = 1.0;
  for (std::size_t side = 0; side < 4; ++side) {
    if (delta[side] == 0.0) {
      if (room[side] < 0.0) {
        return false;
      }
      continue;
    }
    const double t = room[side] / delta[side];
    enter = delta[side] < 0.0 ? std::max(enter, t) : enter;
    leave = delta[side] > 0.0 ? std::min(leave, t) : leave;
  }
  return enter <= leave;
}

} // namespace

bool LabelPlacer::isFree(const QRectF& box, bool mayCoverLines) const {
  return area_.contains(box) &&
         std::ranges::none_of(taken_, [&](const QRectF& other) { return other.intersects(box); }) &&
         (mayCoverLines ||
          std::ranges::none_of(lines_, [&](const QLineF& line) { return crossesBox(box, line); }));
}

QRectF LabelPlacer::boxBeside(QPointF point, QSizeF size, double angle) {
  const QPointF unit(std::cos(angle), std::sin(angle));
  // So far that all of the box lies beyond the gap.
  const double reach = kPointLabelGap + 0.5 * (std::abs(unit.x()) * size.width() +
                                               std::abs(unit.y()) * size.height());
  QRectF box(QPointF(), size);
  box.moveCenter(point + reach * unit);
  return box;
}

std::optional<QRectF> LabelPlacer::find(QPointF point, QSizeF size, QPointF outward,
                                        bool mayCoverLines) const {
  if (!area_.contains(point)) {
    return std::nullopt;
  }
  const double direction = std::atan2(outward.y(), outward.x());
  for (const int eighths : kLabelDirections) {
    const QRectF box = boxBeside(point, size, direction + eighths * std::numbers::pi / 4.0);
    if (isFree(box, mayCoverLines)) {
      return box;
    }
  }
  return std::nullopt;
}

std::optional<QRectF> LabelPlacer::reserved(const std::optional<QRectF>& box) {
  if (box) {
    taken_.push_back(*box);
  }
  return box;
}

std::optional<QRectF> LabelPlacer::reservePlace(QPointF point, QSizeF size, QPointF outward) {
  return reserved(find(point, size, outward, false));
}

std::optional<QRectF> LabelPlacer::reservePlaceOverLines(QPointF point, QSizeF size,
                                                         QPointF outward) {
  const auto free = find(point, size, outward, false);
  return reserved(free ? free : find(point, size, outward, true));
}

std::optional<QRectF> LabelPlacer::reservePlaceInDirection(QPointF point, QSizeF size,
                                                           QPointF outward) {
  const QRectF box = boxBeside(point, size, std::atan2(outward.y(), outward.x()));
  return reserved(area_.contains(point) && isFree(box, false) ? std::optional(box) : std::nullopt);
}

} // namespace dewpoint::ui
