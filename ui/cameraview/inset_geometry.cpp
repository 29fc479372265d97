// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/inset_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewpoint::ui {

namespace {

constexpr double kTightDiameter = 10.0; ///< widget units
constexpr double kUsualInset = 96.0;
constexpr double kSmallestInset = 64.0;
constexpr double kInsetShare = 0.34;    ///< of the shorter side of the view, at most
constexpr double kWideShare = 0.18;     ///< the same, at least, where the view is large
constexpr double kInsetMargin = 8.0;    ///< to the border of the view
constexpr double kAmpleDistance = 72.0; ///< the inset leaves so much room to the target

constexpr double kMostFill = 0.6; ///< share of the inset that the cloud fills
constexpr int kFactorStep = 3;    ///< few steps: the cloud seldom calls for another one
constexpr int kLargestFactor = 243;

double distanceBetween(const QRectF& rect, const QPointF& point) {
  const double dx = std::max({rect.left() - point.x(), point.x() - rect.right(), 0.0});
  const double dy = std::max({rect.top() - point.y(), point.y() - rect.bottom(), 0.0});
  return std::hypot(dx, dy);
}

} // namespace

bool isTightCloud(double diameter) {
  return diameter < kTightDiameter;
}

std::optional<double> insetSideLength(const QRectF& area) {
  const double shorter = std::min(area.width(), area.height());
  const double side =
      std::floor(std::min(std::max(kUsualInset, kWideShare * shorter), kInsetShare * shorter));
  return side >= kSmallestInset ? std::optional(side) : std::nullopt;
}

std::optional<int> insetMagnification(double diameter, double side) {
  std::optional<int> factor;
  for (int larger = 1; larger <= kLargestFactor && diameter * larger <= kMostFill * side;
       larger *= kFactorStep) {
    factor = larger;
  }
  return factor;
}

QRectF insetRect(const QRectF& area, double side, const QPointF& target,
                 const std::vector<QRectF>& taken) {
  const QRectF room = area.adjusted(kInsetMargin, kInsetMargin, -kInsetMargin, -kInsetMargin);
  const double right = room.right() - side;
  const double bottom = room.bottom() - side;
  QRectF best;
  double most = -std::numeric_limits<double>::infinity();
  for (const QPointF& corner : {QPointF(room.left(), bottom), QPointF(right, bottom),
                                QPointF(right, room.top()), room.topLeft()}) {
    const QRectF square(corner, QSizeF(side, side));
    const bool isFree =
        std::ranges::none_of(taken, [&](const QRectF& one) { return one.intersects(square); });
    constexpr double kTakenPenalty = 1e6;
    const double worth =
        std::min(distanceBetween(square, target), kAmpleDistance) - (isFree ? 0.0 : kTakenPenalty);
    if (worth > most) {
      most = worth;
      best = square;
    }
  }
  return best;
}

double scaleBarLength(double scale, double longest) {
  const double most = longest / scale;
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  const double digit = most / power; // 1 to 10
  return power * (digit >= 5.0 ? 5.0 : digit >= 2.0 ? 2.0 : 1.0);
}

} // namespace dewpoint::ui
