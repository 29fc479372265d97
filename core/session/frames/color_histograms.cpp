// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/frames/color_histograms.h"

#include "core/observation/boxes/histogram_similarity.h"

#include <algorithm>
#include <cassert>
#include <functional>

namespace dewpoint::session {
namespace {

/// The inverse of rgbBin(): 8 bins of 32 values per channel.
std::array<std::uint8_t, 3> middleOf(std::size_t bin) {
  const auto channel = [](std::size_t part) { return static_cast<std::uint8_t>(32 * part + 16); };
  return {channel(bin / 64 % 8), channel(bin / 8 % 8), channel(bin % 8)};
}

} // namespace

double ColorHistograms::similarity() const {
  return bhattacharyyaCoefficient(candidate, reference);
}

std::vector<ColorBar> largestBars(const ColorHistograms& histograms, std::size_t most) {
  assert(histograms.reference.size() == histograms.candidate.size());
  const auto shareOf = [&](std::size_t bin) {
    return std::max(histograms.reference[bin], histograms.candidate[bin]);
  };
  std::vector<std::size_t> bins;
  for (std::size_t bin = 0; bin < histograms.reference.size(); ++bin) {
    if (shareOf(bin) > 0.0) {
      bins.push_back(bin);
    }
  }
  std::ranges::stable_sort(bins, std::greater<>(), shareOf);
  bins.resize(std::min(bins.size(), most));
  std::ranges::sort(bins);
  std::vector<ColorBar> bars;
  bars.reserve(bins.size());
  for (const std::size_t bin : bins) {
    bars.push_back({middleOf(bin), histograms.reference[bin], histograms.candidate[bin]});
  }
  return bars;
}

} // namespace dewpoint::session
