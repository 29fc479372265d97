// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"
#include "core/color/color_sample.h"
#include "core/tracking/target_box.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::tracking {

/// Assumed shape of a target.
enum class TargetShape {
  Auto, ///< the images decide whether the target is a ball
  Ball, ///< a sphere
  Any   ///< an object of any shape in one color; its extent is learned
};

/// Definition of a target.
struct Target {
  std::string name;
  /// Radius in meters; 0 if unknown. For a target that is not a ball, this is the radius of a ball
  /// of equal volume.
  double radius = 0.0;
  ColorRange color;
  /// Samples that the color was learned from, if any; trackers use only `color`.
  std::vector<ColorSample> samples{};
  /// Initial bounding box, for methods that track boxes in images. These methods do not use
  /// `color`.
  std::optional<TargetBox> box{};
  /// Assumed shape. Only methods that support targets other than balls (`dewpoint`) use the shape.
  TargetShape shape = TargetShape::Auto;
  /// Colors of a multicolored target in addition to `color`.
  std::vector<ColorRange> otherColors{};
  /// Whether the views draw the target. Has no effect on tracking and results.
  bool isShown = true;

  /// Returns all colors of the target.
  ColorRanges colors() const { return {color, otherColors}; }
  bool operator==(const Target&) const = default;
};

/// Returns whether the two targets are equal, apart from Target::isShown.
inline bool areSameExceptShown(Target a, const Target& b) {
  a.isShown = b.isShown;
  return a == b;
}

} // namespace dewpoint::tracking
