// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace dewpoint::color {

/// Colors of a target. A color belongs to the target if it lies in any of these ranges. Most
/// targets have one color, hence the implicit conversion from a single range.
class ColorRanges {
public:
  /// Creates an empty list, which nothing matches.
  ColorRanges() = default;
  ColorRanges(const ColorRange& range) : ranges_{range} {}
  ColorRanges(const ColorRange& first, const std::vector<ColorRange>& others) : ranges_{first} {
    ranges_.insert(ranges_.end(), others.begin(), others.end());
  }
  explicit ColorRanges(std::vector<ColorRange> ranges) : ranges_(std::move(ranges)) {}

  bool empty() const { return ranges_.empty(); }
  std::size_t size() const { return ranges_.size(); }
  const ColorRange& operator[](std::size_t index) const { return ranges_[index]; }
  auto begin() const { return ranges_.begin(); }
  auto end() const { return ranges_.end(); }
  /// Returns all ranges except the first.
  std::vector<ColorRange> others() const {
    return {ranges_.begin() + (ranges_.empty() ? 0 : 1), ranges_.end()};
  }

  bool operator==(const ColorRanges&) const = default;

private:
  std::vector<ColorRange> ranges_;
};

} // namespace dewpoint::color
