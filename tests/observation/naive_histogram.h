// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace dewpoint::tests {

/// Equations 6 to 8 of Sugandi et al. 2009 written down as they stand, for tests and benchmarks:
/// the histogram of a rectangle of whole size whose upper left corner is a whole pixel.
inline std::array<double, 512> naiveHistogram(const cv::Mat& bgr, const cv::Rect& rectangle) {
  std::array<double, 512> histogram{};
  const double a = 0.5 * std::hypot(rectangle.width, rectangle.height);
  double sum = 0.0;
  for (int y = rectangle.y; y < rectangle.y + rectangle.height; ++y) {
    for (int x = rectangle.x; x < rectangle.x + rectangle.width; ++x) {
      if (x < 0 || y < 0 || x >= bgr.cols || y >= bgr.rows) {
        continue;
      }
      const double dx = x + 0.5 - (rectangle.x + 0.5 * rectangle.width);
      const double dy = y + 0.5 - (rectangle.y + 0.5 * rectangle.height);
      const double r = std::sqrt(dx * dx + dy * dy) / a;
      const double g = r < 1.0 ? 1.0 - r * r : 0.0;
      const auto& color = bgr.at<cv::Vec3b>(y, x);
      const int bin = color[2] / 32 * 64 + color[1] / 32 * 8 + color[0] / 32;
      histogram[static_cast<std::size_t>(bin)] += g;
      sum += g;
    }
  }
  for (double& share : histogram) {
    share = sum > 0.0 ? share / sum : 0.0;
  }
  return histogram;
}

/// Equation 10.
inline double naiveSimilarity(const std::array<double, 512>& p, const std::array<double, 512>& q) {
  double rho = 0.0;
  for (std::size_t bin = 0; bin < p.size(); ++bin) {
    rho += std::sqrt(p[bin] * q[bin]);
  }
  return rho;
}

} // namespace dewpoint::tests
