// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/likelihood/color_density.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dewpoint::color {
namespace {

using BgrLevels = std::array<double, 3>; ///< blue, green, red; gray levels
using CellValues = std::vector<double>;

// The standard deviations of the variants of withLightVariations(), rounded.

/// Natural logarithm of the brightness.
constexpr double kBrightnessSigma = 0.32;
/// Factor of the distance from gray.
constexpr double kFullnessSigma = 0.16;
/// Degrees of hue.
constexpr double kTintSigmaDegrees = 4.4;

/// Standard deviations to either side that colors are spread: 98 % of a normal distribution.
constexpr double kSpreadReach = 2.4;
/// Gray levels, standard deviation per channel: 3 of sensor noise (core/simulation/sensor), and as
/// much again of compression and interpolated color filters. A judgment.
constexpr double kNoiseLevels = 5.0;
/// CellValues to either side that noise reaches: three of its standard deviations.
constexpr std::ptrdiff_t kNoiseReach = 2;

/// A normally distributed deviation, in standard deviations, and its share of the weight.
struct Deviation {
  double sigmas = 0.0;
  double share = 1.0;
};

/// Deviations so close that colors do not lie farther apart than a cell, when one standard
/// deviation moves them by `levels` gray levels.
std::vector<Deviation> normalDeviations(double levels) {
  const int half = static_cast<int>(std::ceil(kSpreadReach * levels / kColorCellLevels));
  std::vector<Deviation> all;
  double sum = 0.0;
  for (int k = -half; k <= half; ++k) {
    const double sigmas = half > 0 ? kSpreadReach * k / half : 0.0;
    all.push_back({sigmas, std::exp(-0.5 * sigmas * sigmas)});
    sum += all.back().share;
  }
  for (Deviation& deviation : all) {
    deviation.share /= sum;
  }
  return all;
}

/// Divides the weight among the eight nearest cells.
void splat(const BgrLevels& color, double weight, CellValues& cells) {
  constexpr double kCellMiddle = 0.5 * (kColorCellLevels - 1.0);
  constexpr auto kLastCell = static_cast<double>(kColorCellsPerChannel - 1);
  std::array<std::size_t, 3> low{};
  BgrLevels beyond{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double at = std::clamp((color[i] - kCellMiddle) / kColorCellLevels, 0.0, kLastCell);
    low[i] = std::min(static_cast<std::size_t>(at), kColorCellsPerChannel - 2);
    beyond[i] = at - static_cast<double>(low[i]);
  }
  for (std::size_t corner = 0; corner < 8; ++corner) {
    std::size_t cell = 0;
    double share = weight;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t upper = (corner >> i) & 1U;
      cell = cell * kColorCellsPerChannel + low[i] + upper;
      share *= upper != 0 ? beyond[i] : 1.0 - beyond[i];
    }
    cells[cell] += share;
  }
}

/// Rotated about the gray axis, to which it is orthogonal.
BgrLevels rotated(const BgrLevels& chroma, double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle) / std::numbers::sqrt3;
  return {cosine * chroma[0] + sine * (chroma[2] - chroma[1]),
          cosine * chroma[1] + sine * (chroma[0] - chroma[2]),
          cosine * chroma[2] + sine * (chroma[1] - chroma[0])};
}

void splatInOtherLight(const BgrLevels& color, double weight, CellValues& cells) {
  const double gray = (color[0] + color[1] + color[2]) / 3.0;
  const BgrLevels chroma{color[0] - gray, color[1] - gray, color[2] - gray};
  const double fullest = std::max({std::abs(chroma[0]), std::abs(chroma[1]), std::abs(chroma[2])});
  const double tintSigma = kTintSigmaDegrees * std::numbers::pi / 180.0;
  // Brightness goes by factors, so that its steps grow: measured from the first deviation to the
  // second.
  const double lightLevels = std::max({color[0], color[1], color[2]}) *
                             (std::exp(2.0 * kBrightnessSigma) - std::exp(kBrightnessSigma));
  const auto lights = normalDeviations(lightLevels);
  const auto fullnesses = normalDeviations(kFullnessSigma * fullest);
  const auto tints = normalDeviations(tintSigma * std::hypot(chroma[0], chroma[1], chroma[2]));
  for (const Deviation& tint : tints) {
    const BgrLevels tinted = rotated(chroma, kTintSigmaDegrees * tint.sigmas);
    for (const Deviation& fullness : fullnesses) {
      const double full = 1.0 + kFullnessSigma * fullness.sigmas;
      const double share = weight * tint.share * fullness.share;
      for (const Deviation& light : lights) {
        const double bright = std::exp(kBrightnessSigma * light.sigmas);
        BgrLevels seen{};
        for (std::size_t i = 0; i < 3; ++i) {
          seen[i] = std::clamp(bright * (gray + full * tinted[i]), 0.0, 255.0);
        }
        splat(seen, share * light.share, cells);
      }
    }
  }
}

using NoiseTaps = std::array<double, kNoiseReach + 1>; ///< of the cell itself, its neighbors, ...

NoiseTaps noiseTaps() {
  NoiseTaps taps{};
  double sum = 0.0;
  for (std::size_t k = 0; k < taps.size(); ++k) {
    const double sigmas = static_cast<double>(k) * kColorCellLevels / kNoiseLevels;
    taps[k] = std::exp(-0.5 * sigmas * sigmas);
    sum += k == 0 ? taps[k] : 2.0 * taps[k];
  }
  for (double& tap : taps) {
    tap /= sum;
  }
  return taps;
}

/// What noise would take beyond the ends is mirrored, so that the weight stays.
std::size_t mirrored(std::ptrdiff_t at) {
  constexpr auto kCellsOfLine = static_cast<std::ptrdiff_t>(kColorCellsPerChannel);
  return static_cast<std::size_t>(at < 0              ? -1 - at
                                  : at < kCellsOfLine ? at
                                                      : 2 * kCellsOfLine - 1 - at);
}

/// Along the channel in which neighboring cells lie `stride` apart.
void spreadByNoise(std::size_t stride, const NoiseTaps& taps, CellValues& cells) {
  std::array<double, kColorCellsPerChannel> line{};
  for (std::size_t first = 0; first < cells.size(); ++first) {
    if (first / stride % kColorCellsPerChannel != 0) {
      continue;
    }
    for (std::size_t i = 0; i < line.size(); ++i) {
      line[i] = cells[first + i * stride];
    }
    for (std::size_t i = 0; i < line.size(); ++i) {
      double sum = 0.0;
      for (std::ptrdiff_t k = -kNoiseReach; k <= kNoiseReach; ++k) {
        sum += taps[static_cast<std::size_t>(std::abs(k))] *
               line[mirrored(static_cast<std::ptrdiff_t>(i) + k)];
      }
      cells[first + i * stride] = sum;
    }
  }
}

} // namespace

ColorDensity::ColorDensity(const std::vector<WeightedBgrColor>& colors, double otherLight)
    : cells_(kColorCellCount, 0.0) {
  double total = 0.0;
  for (const WeightedBgrColor& color : colors) {
    total += color.weight;
    splat(color.bgr, (1.0 - otherLight) * color.weight, cells_);
    if (otherLight > 0.0) {
      splatInOtherLight(color.bgr, otherLight * color.weight, cells_);
    }
  }
  if (total <= 0.0) {
    return;
  }
  const NoiseTaps taps = noiseTaps();
  for (const std::size_t stride :
       {kColorCellsPerChannel * kColorCellsPerChannel, kColorCellsPerChannel, std::size_t{1}}) {
    spreadByNoise(stride, taps, cells_);
  }
  for (double& cell : cells_) {
    cell *= static_cast<double>(kColorCellCount) / total;
  }
}

} // namespace dewpoint::color
