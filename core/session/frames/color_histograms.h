// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace dewpoint::session {

/// The color histograms of a box, as Sugandi et al. 2009, figure 1, shows them: shares of the bins
/// of rgbBin() (512), each summing to 1.
struct ColorHistograms {
  std::vector<double> reference; ///< of the box as it was given
  std::vector<double> candidate; ///< of the box as it is estimated in the image shown

  /// rho of equation 10: 1 for equal histograms, 0 for those without a common bin.
  double similarity() const;
};

/// One bin of both histograms, as a view draws it.
struct ColorBar {
  std::array<std::uint8_t, 3> rgb{}; ///< the color at the center of the bin
  double reference = 0.0;
  double candidate = 0.0;
};

/// The bins with the largest shares in either histogram, at most `most` and none that is empty in
/// both, in the order of their numbers.
std::vector<ColorBar> largestBars(const ColorHistograms& histograms, std::size_t most);

} // namespace dewpoint::session
