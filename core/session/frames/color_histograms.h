// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace dewpoint::session {

/// Color histograms of a box as in Sugandi et al. 2009, figure 1: fractions of the pixels in the
/// 512 bins of rgbBin(). Each histogram sums to 1.
struct ColorHistograms {
  std::vector<double> reference; ///< histogram of the box given by the user
  std::vector<double> candidate; ///< histogram of the estimated box in the displayed image

  /// Returns rho of equation 10: 1 for equal histograms, 0 for histograms without a common bin.
  double similarity() const;
};

/// One bin of both histograms, for display.
struct ColorBar {
  std::array<std::uint8_t, 3> rgb{}; ///< color at the center of the bin
  double reference = 0.0;
  double candidate = 0.0;
};

/// Returns the bins with the largest fractions in either histogram, ordered by bin number: at most
/// `most`, and none that is empty in both.
std::vector<ColorBar> largestBars(const ColorHistograms& histograms, std::size_t most);

} // namespace dewpoint::session
