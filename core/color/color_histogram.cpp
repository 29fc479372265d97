// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_histogram.h"

#include "core/base/units.h"
#include "core/color/hsi.h"
#include "core/color/hsi_counts.h"

#include <cmath>

namespace dewpoint::color {

ColorHistogram histogramOf(const std::vector<cv::Mat>& images) {
  HsiCounts counts;
  for (const cv::Mat& image : images) {
    counts.add(image, cv::Mat());
  }
  ColorHistogram histogram;
  double total = 0.0;
  for (const WeightedHsiColor& cell : counts.colors()) {
    total += cell.weight;
    if (!std::isnan(cell.color.hueDegrees)) {
      histogram.hue[std::size_t(std::lround(cell.color.hueDegrees)) % 360] += cell.weight;
    }
    histogram.saturation[std::size_t(std::lround(inPercent(cell.color.saturation)))] += cell.weight;
    histogram.intensity[std::size_t(std::lround(inPercent(cell.color.intensity)))] += cell.weight;
  }
  const double scale = total > 0.0 ? 1.0 / total : 0.0;
  for (double& share : histogram.hue) {
    share *= scale;
  }
  for (double& share : histogram.saturation) {
    share *= scale;
  }
  for (double& share : histogram.intensity) {
    share *= scale;
  }
  return histogram;
}

} // namespace dewpoint::color
