// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"
#include "core/color/color_sample.h"
#include "core/tracking/target_box.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::tracking {

/// What a target is taken for.
enum class TargetShape {
  Auto, ///< the images decide whether it is a ball
  Ball, ///< a sphere
  Any   ///< anything of one color: its extent is learned
};

/// The definition of a target.
struct Target {
  std::string name;
  double radius = 0.0; ///< meters; 0 when unknown. Of a target that is no ball: of equal volume
  ColorRange color;
  /// The samples that the color was learned from, if it was; trackers use `color` alone.
  std::vector<ColorSample> samples{};
  /// The first box, for methods that track boxes in images; they do not use the color.
  std::optional<TargetBox> box{};
  /// For methods that know targets which are no balls (`dewpoint`); others do not use it.
  TargetShape shape = TargetShape::Auto;
  /// Of a target of several colors, those besides `color`.
  std::vector<ColorRange> otherColors{};

  ColorRanges colors() const { return {color, otherColors}; }
  bool operator==(const Target&) const = default;
};

} // namespace dewpoint::tracking
