// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/color_score.h"

#include "bench/pixel_truth.h"
#include "core/base/statistics.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace dewpoint::bench {
namespace {

/// The probability that a pixel of the target has a higher value than another pixel, equal values
/// counting half (Mann and Whitney 1947); 0.5 if there are none to compare.
double areaUnderRoc(const cv::Mat& values, const cv::Mat& target, const cv::Mat& counted) {
  std::array<double, 256> targets{};
  std::array<double, 256> others{};
  for (int y = 0; y < values.rows; ++y) {
    const std::int8_t* value = values.ptr<std::int8_t>(y);
    const std::uint8_t* isTarget = target.ptr<std::uint8_t>(y);
    const std::uint8_t* counts = counted.ptr<std::uint8_t>(y);
    for (int x = 0; x < values.cols; ++x) {
      if (counts[x] != 0) {
        (isTarget[x] != 0 ? targets : others)[static_cast<std::size_t>(value[x] + 128)] += 1.0;
      }
    }
  }
  double higher = 0.0;
  double allTargets = 0.0;
  double allOthers = 0.0;
  for (std::size_t value = 0; value < targets.size(); ++value) {
    higher += targets[value] * (allOthers + 0.5 * others[value]);
    allTargets += targets[value];
    allOthers += others[value];
  }
  return allTargets > 0.0 && allOthers > 0.0 ? higher / (allTargets * allOthers) : 0.5;
}

} // namespace

ColorScore colorScore(const cv::Mat& values, const ColorTruth& truth) {
  const cv::Mat match = values > 0;
  const auto f1 = [&](const cv::Mat& counted) {
    return pixelScore(match & counted, truth.target & counted).f1();
  };
  return {pixelScore(match, truth.target).f1(), f1(truth.whole), f1(truth.near),
          areaUnderRoc(values, truth.target, truth.whole)};
}

ColorScore medianOf(const std::vector<ColorScore>& scores) {
  const auto each = [&](double ColorScore::*measure) {
    std::vector<double> values;
    std::ranges::transform(scores, std::back_inserter(values), measure);
    return upperMedian(std::move(values));
  };
  return {each(&ColorScore::strict), each(&ColorScore::whole), each(&ColorScore::near),
          each(&ColorScore::rocArea)};
}

} // namespace dewpoint::bench
