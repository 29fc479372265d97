// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace dewpoint::color {

/// Color ranges of a target. A color belongs to the target if it lies in any of the ranges. Most
/// targets have only one range, so a single range converts implicitly to ColorRanges.
class ColorRanges {
public:
  /// Creates an empty list of ranges. No color matches an empty list.
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
  std::vector<ColorRange> rangesAfterFirst() const {
    return {ranges_.begin() + (ranges_.empty() ? 0 : 1), ranges_.end()};
  }

  bool operator==(const ColorRanges&) const = default;

private:
  std::vector<ColorRange> ranges_;
};

} // namespace dewpoint::color
