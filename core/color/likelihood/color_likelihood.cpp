// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/likelihood/color_likelihood.h"

#include "core/base/vector_kernel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstring>

namespace dewpoint::color {

void ColorLikelihood::Bounds::include(int value) {
  const auto one = static_cast<std::int16_t>(value);
  const bool isFirst = lowest > highest;
  lowest = isFirst ? one : std::min(lowest, one);
  highest = isFirst ? one : std::max(highest, one);
}

ColorLikelihood::ColorLikelihood(const std::vector<double>& logRatios) {
  assert(logRatios.size() == kColorCellCount);
  const auto steps = std::make_shared<Steps>();
  for (std::size_t cell = 0; cell < kColorCellCount; ++cell) {
    assert(std::isfinite(logRatios[cell]));
    const double bounded = std::clamp(logRatios[cell], -kMaxLogRatio, kMaxLogRatio);
    (*steps)[cell] = static_cast<std::int8_t>(std::lround(bounded / kLogRatioStep));
    if ((*steps)[cell] > -kMaxLogRatioSteps) {
      const auto coordinates =
          boundedCoordinates(static_cast<int>(cell >> 10U), static_cast<int>((cell >> 5U) & 31U),
                             static_cast<int>(cell & 31U));
      for (std::size_t i = 0; i < coordinates.size(); ++i) {
        reach_[i].include(coordinates[i]);
      }
    }
  }
  steps_ = steps;
}

/// ColorLikelihood::computeLogRatioRow(). Cells and whether any is in reach are found side by side;
/// looking cells up, one by one, takes most of the time.
struct LogRatioKernel {
  /// Pixels: short, so that runs without the target are frequent, yet many registers wide.
  static constexpr int kRun = 128;

  struct Beyond {
    std::int16_t least, most;

    explicit Beyond(const ColorLikelihood::Bounds& bounds)
        : least(bounds.lowest), most(bounds.highest) {}

    /// Negative outside the bounds.
    [[gnu::always_inline]] std::int16_t operator()(std::int16_t value) const {
      return static_cast<std::int16_t>(static_cast<std::int16_t>(value - least) |
                                       static_cast<std::int16_t>(most - value));
    }
  };

  /// The cells of the pixels; true if one of them is in reach.
  DEWPOINT_KERNEL bool findCells(const ColorLikelihood& likelihood,
                                 const std::uint8_t* __restrict pixels, int count,
                                 std::uint16_t* __restrict cells) {
    const Beyond redGreen(likelihood.reach_[0]);
    const Beyond greenBlue(likelihood.reach_[1]);
    const Beyond redBlue(likelihood.reach_[2]);
    const Beyond sum(likelihood.reach_[3]);
    std::int16_t allOutside = -1;
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      const auto b = static_cast<std::int16_t>(pixels[3 * i] >> 3);
      const auto g = static_cast<std::int16_t>(pixels[3 * i + 1] >> 3);
      const auto r = static_cast<std::int16_t>(pixels[3 * i + 2] >> 3);
      cells[i] = static_cast<std::uint16_t>((b << 10) | (g << 5) | r);
      const auto outside = static_cast<std::int16_t>(
          redGreen(static_cast<std::int16_t>(r - g)) | greenBlue(static_cast<std::int16_t>(g - b)) |
          redBlue(static_cast<std::int16_t>(r - b)) | sum(static_cast<std::int16_t>(r + g + b)));
      allOutside = static_cast<std::int16_t>(allOutside & outside);
    }
    return allOutside >= 0;
  }

  DEWPOINT_KERNEL void run(const ColorLikelihood* likelihood, const std::uint8_t* bgr,
                           std::int64_t count, std::int8_t* __restrict out) {
    alignas(64) std::uint16_t cells[kRun];
    const std::int8_t* __restrict steps = likelihood->steps_->data();
    for (std::int64_t begin = 0; begin < count; begin += kRun) {
      const int length = count - begin < kRun ? static_cast<int>(count - begin) : kRun;
      if (findCells(*likelihood, bgr + 3 * begin, length, cells)) {
        for (std::ptrdiff_t i = 0; i < length; ++i) {
          out[begin + i] = steps[cells[i]];
        }
      } else {
        std::memset(out + begin, static_cast<std::uint8_t>(-ColorLikelihood::kMaxLogRatioSteps),
                    static_cast<std::size_t>(length));
      }
    }
  }
};

void ColorLikelihood::computeLogRatioRow(const std::uint8_t* bgr, std::int64_t count,
                                         std::int8_t* out) const noexcept {
  runKernel<LogRatioKernel>(this, bgr, count, out);
}

void ColorLikelihood::matchRow(const std::uint8_t* bgr, std::int64_t count, std::uint8_t* out,
                               double threshold) const noexcept {
  constexpr std::int64_t kBuffer = 1024; // pixels, a small part of the cache
  // A whole number exceeds the threshold where it exceeds the whole number below.
  const auto most =
      static_cast<std::int8_t>(std::clamp(std::floor(threshold / kLogRatioStep), -128.0, 127.0));
  std::array<std::int8_t, kBuffer> steps;
  for (std::int64_t begin = 0; begin < count; begin += kBuffer) {
    const std::int64_t length = std::min(kBuffer, count - begin);
    computeLogRatioRow(bgr + 3 * begin, length, steps.data());
    for (std::int64_t i = 0; i < length; ++i) {
      out[begin + i] = steps[static_cast<std::size_t>(i)] > most ? 255 : 0;
    }
  }
}

} // namespace dewpoint::color
