// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"
#include "core/color/color_sample.h"
#include "core/tracking/target_box.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::tracking {

/// What is tracked.
struct Target {
  std::string name;
  double radius = 0.0; ///< meters; 0 when unknown
  ColorRange color;
  /// What the color was learned from, if it was; the trackers go by `color` alone.
  std::vector<ColorSample> samples{};
  /// What the methods that follow boxes go by, in place of a color.
  std::optional<TargetBox> box{};

  bool operator==(const Target&) const = default;
};

} // namespace dewpoint::tracking
