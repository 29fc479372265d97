// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/sensor/shutter.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace dewpoint::simulation {
namespace {

/// Rows of a band, chosen: of 240 rows read out in 20 ms they take 1.3 ms, in which what crosses
/// such an image in a third of a second travels 1.3 pixels, a tenth of its motion blur.
constexpr int kBandRows = 16;

} // namespace

double rowTime(const Shutter& shutter, int row, int rows) {
  if (rows < 2) {
    return 0.0;
  }
  return shutter.readoutSeconds * (static_cast<double>(row) / (rows - 1) - 0.5);
}

std::vector<RowBand> rowBands(const Shutter& shutter, int rows) {
  if (shutter.readoutSeconds <= 0.0) {
    return {{0, rows, 0.0}};
  }
  std::vector<RowBand> bands;
  bands.reserve(static_cast<std::size_t>(rows / kBandRows) + 1);
  for (int begin = 0; begin < rows; begin += kBandRows) {
    const int end = std::min(rows, begin + kBandRows);
    const double middle = 0.5 * (rowTime(shutter, begin, rows) + rowTime(shutter, end - 1, rows));
    bands.push_back({begin, end, middle});
  }
  return bands;
}

std::vector<float> rowGains(const Flicker& flicker, const Shutter& shutter, int rows, double time) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  // The mean of a sine over an exposure is that at its middle, times sin(x) / x.
  const double half = 0.5 * kTurn * flicker.frequencyHz * shutter.exposureSeconds;
  const double kept = half > 0.0 ? std::sin(half) / half : 1.0;
  std::vector<float> gains(static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) {
    const double at = time + rowTime(shutter, row, rows);
    const double swing = std::sin(kTurn * flicker.frequencyHz * at + flicker.phaseRadians);
    gains[static_cast<std::size_t>(row)] =
        static_cast<float>(1.0 + flicker.modulationDepth * kept * swing);
  }
  return gains;
}

} // namespace dewpoint::simulation
