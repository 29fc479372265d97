// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/boxes/box_without_margin.h"

#include "core/color/rgb_bins.h"
#include "core/observation/boxes/fine_histogram.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <numeric>

namespace dewpoint::observation {
namespace {

// docs/method-sugandi.md has the steps; the origin of the values is not recorded.

/// Share of the center of a drawn box that is assumed to be ground; share of its sides that is
/// always kept.
constexpr double kGround = 0.5;
constexpr double kLeastSide = 0.5;
constexpr double kNeutral = 0.5; ///< P(figure | color) that says nothing

FineHistogram figureColors(const FineHistogram& center, const FineHistogram& ground) {
  FineHistogram figure(center.size());
  for (std::size_t bin = 0; bin < center.size(); ++bin) {
    figure[bin] = std::max(0.0, center[bin] - kGround * ground[bin]);
  }
  const double sum = std::accumulate(figure.begin(), figure.end(), 0.0);
  for (double& share : figure) {
    share = sum > 0.0 ? share / sum : 0.0;
  }
  return figure;
}

/// The integral image of P(figure | color) - 1/2 in a part of an image.
cv::Mat evidence(const cv::Mat& bgr, const cv::Rect& part, const ImageBox& drawn) {
  const FineHistogram ground = surroundingsHistogramOf(bgr, drawn);
  const FineHistogram figure = figureColors(centralHistogramOf(bgr, drawn), ground);
  cv::Mat map(part.size(), CV_64F);
  for (int y = 0; y < part.height; ++y) {
    const auto* row = bgr.ptr<cv::Vec3b>(part.y + y) + part.x;
    for (int x = 0; x < part.width; ++x) {
      const std::size_t bin = fineRgbBin(row[x][0], row[x][1], row[x][2]);
      const double f = figure[bin] + kChanceShare;
      const double b = ground[bin] + kChanceShare;
      map.at<double>(y, x) = f / (f + b) - kNeutral;
    }
  }
  cv::Mat integral;
  cv::integral(map, integral, CV_64F);
  return integral;
}

/// The interval of columns, at least `least` of them, with the greatest sum between two rows.
struct Interval {
  double sum = 0.0;
  int begin = 0;
  int end = 0;
};

Interval bestColumns(const double* top, const double* bottom, int columns, int least) {
  Interval best;
  int lowest = 0; // where the sums up to a column are least
  const auto upTo = [&](int column) { return bottom[column] - top[column]; };
  for (int end = least; end <= columns; ++end) {
    const int begin = end - least;
    lowest = upTo(begin) < upTo(lowest) ? begin : lowest;
    const double sum = upTo(end) - upTo(lowest);
    best = sum > best.sum ? Interval{sum, lowest, end} : best;
  }
  return best;
}

} // namespace

ImageBox boxWithoutMargin(const cv::Mat& bgr, const ImageBox& drawn) {
  const cv::Rect part = clippedToImage(drawn, bgr);
  if (part.empty()) {
    return drawn;
  }
  const cv::Mat sums = evidence(bgr, part, drawn);
  const int leastWidth = std::max(2, static_cast<int>(kLeastSide * drawn.width));
  const int leastHeight = std::max(2, static_cast<int>(kLeastSide * drawn.height));
  double most = 0.0;
  ImageBox best = drawn;
  for (int top = 0; top + leastHeight <= part.height; ++top) {
    for (int bottom = top + leastHeight; bottom <= part.height; ++bottom) {
      const Interval columns =
          bestColumns(sums.ptr<double>(top), sums.ptr<double>(bottom), part.width, leastWidth);
      if (columns.sum > most) {
        most = columns.sum;
        best = {double(part.x + columns.begin), double(part.y + top),
                double(columns.end - columns.begin), double(bottom - top)};
      }
    }
  }
  return best;
}

} // namespace dewpoint::observation
