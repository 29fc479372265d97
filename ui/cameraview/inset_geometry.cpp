// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/inset_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dewpoint::ui {

namespace {

constexpr double kTightDiameter = 10.0; ///< widget units
constexpr double kWideDiameter = 14.0;  ///< of one that was tight
constexpr double kUsualInset = 96.0;
constexpr double kSmallestInset = 64.0;
constexpr double kInsetShare = 0.34;     ///< of the shorter side of the view, at most
constexpr double kWideShare = 0.18;      ///< the same, at least, where the view is large
constexpr double kInsetMargin = 8.0;     ///< to the border of the view
constexpr double kInsetClearance = 20.0; ///< a target this near drives the inset away
constexpr double kAmpleDistance = 72.0;  ///< a new inset leaves so much room to the target

// Shares of the inset that the cloud fills.
constexpr double kAimedFill = 0.5;
constexpr double kLeastFill = 0.18;
constexpr double kMostFill = 0.7;

constexpr std::array<int, 17> kFactors{1,  2,  3,  4,  6,   8,   12,  16, 24,
                                       32, 48, 64, 96, 128, 192, 256, 384};

double distanceBetween(const QRectF& rect, const QPointF& point) {
  const double dx = std::max({rect.left() - point.x(), point.x() - rect.right(), 0.0});
  const double dy = std::max({rect.top() - point.y(), point.y() - rect.bottom(), 0.0});
  return std::hypot(dx, dy);
}

} // namespace

bool isTightCloud(double diameter, bool wasTight) {
  return diameter > 0.0 && diameter < (wasTight ? kWideDiameter : kTightDiameter);
}

std::optional<double> insetSide(const QRectF& area) {
  const double shorter = std::min(area.width(), area.height());
  const double side =
      std::floor(std::min(std::max(kUsualInset, kWideShare * shorter), kInsetShare * shorter));
  return side >= kSmallestInset ? std::optional(side) : std::nullopt;
}

std::optional<int> insetFactor(double diameter, double side, std::optional<int> before) {
  if (before) {
    const double fill = diameter * *before / side;
    const bool isLargest = *before == kFactors.back();
    if ((fill >= kLeastFill || isLargest) && fill <= kMostFill) {
      return before;
    }
  }
  std::optional<int> factor;
  for (const int larger : kFactors) {
    if (diameter * larger <= kAimedFill * side) {
      factor = larger;
    }
  }
  return factor;
}

InsetPlace insetPlace(const QRectF& area, double side, const QPointF& target,
                      const std::vector<QRectF>& taken, std::optional<int> before) {
  const QRectF room = area.adjusted(kInsetMargin, kInsetMargin, -kInsetMargin, -kInsetMargin);
  const auto squareAt = [&](int corner) {
    return QRectF(corner % 2 == 0 ? room.left() : room.right() - side,
                  corner < 2 ? room.top() : room.bottom() - side, side, side);
  };
  const auto isFree = [&](const QRectF& square) {
    return std::ranges::none_of(taken, [&](const QRectF& one) { return one.intersects(square); });
  };
  if (before && isFree(squareAt(*before)) &&
      distanceBetween(squareAt(*before), target) >= kInsetClearance) {
    return {*before, squareAt(*before)};
  }
  // The nearest one that leaves room around the target, so that the line to it is short; else the
  // farthest.
  InsetPlace best;
  double least = std::numeric_limits<double>::infinity();
  for (int corner = 0; corner < 4; ++corner) {
    const QRectF square = squareAt(corner);
    const double distance = distanceBetween(square, target);
    constexpr double kTooNearPenalty = 1e6;
    constexpr double kTakenPenalty = 1e9;
    const double cost = (distance >= kAmpleDistance ? distance : kTooNearPenalty - distance) +
                        (isFree(square) ? 0.0 : kTakenPenalty);
    if (cost < least) {
      least = cost;
      best = {corner, square};
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
