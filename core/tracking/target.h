// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"
#include "core/color/color_sample.h"
#include "core/tracking/target_box.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::tracking {

/// The definition of a target.
struct Target {
  std::string name;
  double radius = 0.0; ///< meters; 0 when unknown
  ColorRange color;
  /// The samples that the color was learned from, if it was; trackers use `color` alone.
  std::vector<ColorSample> samples{};
  /// The first box, for methods that track boxes in images; they do not use the color.
  std::optional<TargetBox> box{};

  bool operator==(const Target&) const = default;
};

} // namespace dewpoint::tracking
