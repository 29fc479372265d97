// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/likelihood/color_cells.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace dewpoint::color {

/// Log likelihood ratio of a pixel's color in one camera: ln(p(color | target) / p(color | not
/// target)). The ratio is stored as a table over the cells of color_cells.h, which TargetColorModel
/// learns. The table never changes, and copies share it.
class ColorLikelihood {
public:
  /// Step size of table entries, in nats (units of the natural logarithm). It is a power of two,
  /// and smaller than the error of any learned table.
  static constexpr double kLogRatioStep = 1.0 / 16.0;
  /// Largest absolute log ratio of a color, in steps. 72 steps are 4.5 nats, which is ln(0.9 /
  /// 0.01). The assumption is that nine in ten target pixels have the target's color, and that one
  /// in a hundred of all other pixels has this color by chance. For a matching pixel,
  /// core/observation/sphere/sphere_evidence.cpp uses the same values.
  static constexpr int kMaxLogRatioSteps = 72;
  /// Largest absolute log ratio of a color, nats.
  static constexpr double kMaxLogRatio = kMaxLogRatioSteps * kLogRatioStep;

  /// Creates a table from the log ratio of each cell in nats: kColorCellCount finite numbers. The
  /// numbers are rounded to steps and clamped to [-kMaxLogRatio, kMaxLogRatio].
  explicit ColorLikelihood(const std::vector<double>& logRatios);

  /// Returns the log likelihood ratio of a color, in steps of kLogRatioStep.
  std::int8_t logRatioSteps(std::uint8_t blue, std::uint8_t green,
                            std::uint8_t red) const noexcept {
    return (*steps_)[colorCell(blue, green, red)];
  }
  /// Returns the log likelihood ratio of a color, in nats (units of the natural logarithm).
  double logRatio(std::uint8_t blue, std::uint8_t green, std::uint8_t red) const noexcept {
    return kLogRatioStep * logRatioSteps(blue, green, red);
  }

  /// Computes the log likelihood ratio, in steps of kLogRatioStep, of `count` adjacent pixels of
  /// three bytes (blue, green, red). `out` must not overlap the pixels. Runs of pixels that cannot
  /// belong to the target are skipped without a table lookup.
  void computeLogRatioRow(const std::uint8_t* bgr, std::int64_t count,
                          std::int8_t* out) const noexcept;
  /// Classifies `count` adjacent pixels like ColorClassifier::matchRow(). Writes 255 where the log
  /// ratio exceeds `threshold` (nats), and 0 elsewhere.
  void matchRow(const std::uint8_t* bgr, std::int64_t count, std::uint8_t* out,
                double threshold = 0.0) const noexcept;

  /// Returns whether the tables are equal.
  bool operator==(const ColorLikelihood& other) const { return *steps_ == *other.steps_; }

private:
  friend struct LogRatioKernel;

  /// Inclusive bounds, in cells.
  struct Bounds {
    std::int16_t lowest = 1; ///< if above `highest`, the interval is empty
    std::int16_t highest = 0;

    void include(int value);
  };
  /// Bounds of red - green, green - blue, red - blue and the sum of the channels, over all cells
  /// whose log ratio is above the lowest one. The colors of a single-hue target lie in a wedge that
  /// these bounds enclose tightly.
  using ChannelBounds = std::array<Bounds, 4>;
  static std::array<int, 4> boundedCoordinates(int blue, int green, int red) {
    return {red - green, green - blue, red - blue, red + green + blue};
  }

  using Steps = std::array<std::int8_t, kColorCellCount>;
  std::shared_ptr<const Steps> steps_;
  ChannelBounds reach_;
};

} // namespace dewpoint::color
