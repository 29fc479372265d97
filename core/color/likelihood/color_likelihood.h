// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/likelihood/color_cells.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace dewpoint::color {

/// How much a pixel's color speaks for the target in one camera:
/// log p(color | target) / p(color | not target), natural logarithm, as a table over the cells of
/// color_cells.h. TargetColorModel learns it. A finished value that never changes; copies share the
/// table.
class ColorLikelihood {
public:
  /// What one step of a table entry is worth, in nats: a power of two, finer than any table is
  /// known.
  static constexpr double kStep = 1.0 / 16.0;
  /// The most that a color says for or against, in steps. 72 are 4.5 nats, ln(0.9 / 0.01): of the
  /// target's pixels nine in ten show its color, of others one in a hundred by chance
  /// (core/observation/sphere/sphere_evidence.cpp says the same of a pixel that matches).
  static constexpr int kMostSteps = 72;
  static constexpr double kMost = kMostSteps * kStep; ///< nats

  /// The log ratio of each cell in nats, kColorCellCount finite numbers; rounded to steps, and cut
  /// off at kMost on either side.
  explicit ColorLikelihood(const std::vector<double>& logRatios);

  /// The log ratio of a color, in steps.
  std::int8_t at(std::uint8_t blue, std::uint8_t green, std::uint8_t red) const noexcept {
    return (*steps_)[colorCell(blue, green, red)];
  }
  /// The same in nats.
  double logRatio(std::uint8_t blue, std::uint8_t green, std::uint8_t red) const noexcept {
    return kStep * at(blue, green, red);
  }

  /// at() for `count` pixels of three bytes (blue, green, red) side by side. `out` must not overlap
  /// the pixels. Where no pixel of a run can be the target's, nothing is looked up.
  void logRatioRow(const std::uint8_t* bgr, std::int64_t count, std::int8_t* out) const noexcept;
  /// ColorClassifier::matchRow() by this table: 255 where the log ratio exceeds `threshold` (nats),
  /// 0 elsewhere.
  void matchRow(const std::uint8_t* bgr, std::int64_t count, std::uint8_t* out,
                double threshold = 0.0) const noexcept;

  /// True if every color says the same.
  bool operator==(const ColorLikelihood& other) const { return *steps_ == *other.steps_; }

private:
  friend struct LogRatioKernel;

  /// Inclusive bounds, in cells.
  struct Bounds {
    std::int16_t least = 1; ///< above `most`: nothing is within
    std::int16_t most = 0;

    void include(int value);
  };
  /// Of all cells above the lowest log ratio: red - green, green - blue, red - blue, and the sum. A
  /// target of one hue lies in a wedge of colors that these bounds enclose closely.
  using Reach = std::array<Bounds, 4>;
  static std::array<int, 4> placeInReach(int blue, int green, int red) {
    return {red - green, green - blue, red - blue, red + green + blue};
  }

  using Steps = std::array<std::int8_t, kColorCellCount>;
  std::shared_ptr<const Steps> steps_;
  Reach reach_;
};

} // namespace dewpoint::color
