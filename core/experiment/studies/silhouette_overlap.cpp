// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/silhouette_overlap.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::experiment {
namespace {

double ratio(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole)
                   : std::numeric_limits<double>::quiet_NaN();
}

/// An interval of columns; empty when `first` > `last`.
struct Span {
  double first = std::numeric_limits<double>::infinity();
  double last = -std::numeric_limits<double>::infinity();

  void add(double column) {
    first = std::min(first, column);
    last = std::max(last, column);
  }
};

/// Where the row of pixel centers at `row` lies in the polygon.
Span spanOf(const std::vector<Eigen::Vector2d>& outline, double row) {
  Span span;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Eigen::Vector2d& from = outline[k];
    const Eigen::Vector2d& to = outline[(k + 1) % outline.size()];
    if (row < std::min(from.y(), to.y()) || row > std::max(from.y(), to.y())) {
      continue;
    }
    if (from.y() == to.y()) {
      span.add(from.x());
      span.add(to.x());
    } else {
      span.add(from.x() + (row - from.y()) / (to.y() - from.y()) * (to.x() - from.x()));
    }
  }
  return span;
}

} // namespace

cv::Mat filledOutline(const std::vector<Eigen::Vector2d>& outline, cv::Size size) {
  cv::Mat mask = cv::Mat::zeros(size, CV_8UC1);
  if (outline.size() < 3) {
    return mask;
  }
  for (int row = 0; row < mask.rows; ++row) {
    const Span span = spanOf(outline, row);
    const double first = std::ceil(std::max(0.0, span.first));
    const double last = std::floor(std::min(mask.cols - 1.0, span.last));
    if (first <= last) {
      mask.row(row)
          .colRange(static_cast<int>(first), static_cast<int>(last) + 1)
          .setTo(cv::Scalar(255));
    }
  }
  return mask;
}

double SilhouetteOverlap::recall() const {
  return ratio(commonPixelCount, truePixelCount);
}

double SilhouetteOverlap::precision() const {
  return ratio(commonPixelCount, estimatedPixelCount);
}

double SilhouetteOverlap::iou() const {
  return ratio(commonPixelCount, truePixelCount + estimatedPixelCount - commonPixelCount);
}

SilhouetteOverlap overlapOf(const cv::Mat& estimate, const cv::Mat& visible, const cv::Mat& whole) {
  const cv::Mat inEstimate = estimate != 0;
  const cv::Mat inVisible = visible != 0;
  const cv::Mat hidden = (whole != 0) & ~inVisible;
  SilhouetteOverlap overlap;
  overlap.truePixelCount = cv::countNonZero(inVisible);
  overlap.commonPixelCount = cv::countNonZero(inEstimate & inVisible);
  overlap.estimatedPixelCount = cv::countNonZero(inEstimate & ~hidden);
  return overlap;
}

} // namespace dewpoint::experiment
