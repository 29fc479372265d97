// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace dewpoint::session {

/// Color histograms of a bounding box (Sugandi et al. 2009, figure 1): the fraction of the pixels
/// in each of the 512 color bins of rgbBin(). The values of each histogram sum to 1.
struct ColorHistograms {
  std::vector<double> reference; ///< histogram of the box given by the user
  std::vector<double> candidate; ///< histogram of the estimated box in the displayed image

  /// Returns the similarity of the two histograms (rho of equation 10): 1 if they are equal, 0 if
  /// they have no color bin in common.
  double similarity() const;
};

/// One color bin of both histograms, for display.
struct ColorBar {
  std::array<std::uint8_t, 3> rgb{}; ///< color at the center of the bin
  double referenceShare = 0.0;
  double candidateShare = 0.0;
};

/// Returns the bins with the largest fractions in either histogram, ordered by bin number. Returns
/// at most `most` bins. Bins that are empty in both histograms are left out.
std::vector<ColorBar> largestBars(const ColorHistograms& histograms, std::size_t most);

} // namespace dewpoint::session
