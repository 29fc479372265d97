// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace dewpoint::color {

/// Number of color cells per channel. 32 x 32 x 32 cells of 8 gray levels per channel cover all
/// colors. Gray levels are approximately proportional to the square root of the light, and so is
/// the noise of the light. Therefore, a step of one gray level is about the same number of standard
/// deviations everywhere. Cells of equal hue and saturation, in contrast, would be finer than the
/// noise in dark colors, and unnecessarily coarse in bright colors. A cell is about as wide as the
/// noise, which consists of sensor noise (3 levels to either side) and compression. A table with
/// one byte per cell fits into the first-level cache.
inline constexpr std::size_t kColorCellsPerChannel = 32;
inline constexpr std::size_t kColorCellCount = 32768;
inline constexpr double kColorCellLevels = 8.0; ///< gray levels per cell and channel

/// Returns the cell index of a color. Blue varies slowest, red fastest.
inline std::uint16_t colorCell(std::uint8_t blue, std::uint8_t green, std::uint8_t red) {
  return static_cast<std::uint16_t>(((blue >> 3) << 10) | ((green >> 3) << 5) | (red >> 3));
}

/// Group of similar colors: blue, green and red in gray levels, 0 to 255, and their total weight.
struct WeightedBgrColor {
  std::array<double, 3> bgr{};
  double weight = 0.0;
};

} // namespace dewpoint::color
