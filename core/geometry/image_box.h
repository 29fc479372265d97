// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>

#include <algorithm>

namespace dewpoint::geometry {

/// Upright rectangle in an image, in pixels. Coordinates start at the upper left corner of the
/// image, not at the center of its first pixel: pixel (column, row) covers [column, column + 1) x
/// [row, row + 1).
struct ImageBox {
  double x = 0.0; ///< left edge
  double y = 0.0; ///< upper edge
  double width = 0.0;
  double height = 0.0;

  Eigen::Vector2d center() const { return {x + 0.5 * width, y + 0.5 * height}; }
  /// Returns the area, px².
  double area() const { return width * height; }
  bool isEmpty() const { return !(width > 0.0 && height > 0.0); }
  bool operator==(const ImageBox&) const = default;

  /// Returns the box of the given size around a center, all in pixels.
  static ImageBox around(const Eigen::Vector2d& center, double width, double height) {
    return {center.x() - 0.5 * width, center.y() - 0.5 * height, width, height};
  }
};

/// Returns the area of the intersection of two boxes, px², or 0 if they do not intersect.
inline double intersectionArea(const ImageBox& one, const ImageBox& other) {
  const double across =
      std::min(one.x + one.width, other.x + other.width) - std::max(one.x, other.x);
  const double down =
      std::min(one.y + one.height, other.y + other.height) - std::max(one.y, other.y);
  return std::max(0.0, across) * std::max(0.0, down);
}

/// Returns the area of the intersection of two boxes divided by the area of their union, in [0, 1].
/// Returns 0 if a box is empty.
inline double intersectionOverUnion(const ImageBox& one, const ImageBox& other) {
  const double common = intersectionArea(one, other);
  return common > 0.0 ? common / (one.area() + other.area() - common) : 0.0;
}

} // namespace dewpoint::geometry
