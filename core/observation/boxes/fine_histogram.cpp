// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/boxes/fine_histogram.h"

#include "core/color/rgb_bins.h"

#include <cmath>
#include <numeric>

namespace dewpoint::observation {
namespace {

// The origin of the values is not recorded.

/// Share of a bin's count that goes to each neighbor: a color lies anywhere in its bin, noise of a
/// few gray levels carries it over the edge.
constexpr double kToNeighbor = 0.25;
/// The ring around a box that shows its surroundings: share of its sides, and pixels.
constexpr double kBackgroundRing = 0.5;
constexpr double kRingPx = 8.0;
/// Share of the whole image in the surroundings: what the target may come to next.
constexpr double kElsewhere = 0.3;
constexpr int kElsewhereStep = 4; // pixels

void smooth(FineHistogram& histogram) {
  constexpr int kSide = kFineRgbBinsPerChannel;
  FineHistogram next(histogram.size());
  for (const int stride : {1, kSide, kSide * kSide}) {
    for (int bin = 0; bin < kFineRgbBinCount; ++bin) {
      const int level = bin / stride % kSide;
      const auto at = [&](int other) { return histogram[static_cast<std::size_t>(other)]; };
      const double below = at(level > 0 ? bin - stride : bin);
      const double above = at(level + 1 < kSide ? bin + stride : bin);
      next[static_cast<std::size_t>(bin)] =
          (1.0 - 2.0 * kToNeighbor) * at(bin) + kToNeighbor * (below + above);
    }
    histogram.swap(next);
  }
}

/// Makes counts shares.
void conclude(FineHistogram& histogram) {
  const double sum = std::accumulate(histogram.begin(), histogram.end(), 0.0);
  for (double& share : histogram) {
    share = sum > 0.0 ? share / sum : 0.0;
  }
  smooth(histogram);
}

/// Of the pixels of `part` that are not in `hole`, every `step`-th in both directions.
FineHistogram histogramAround(const cv::Mat& bgr, const cv::Rect& part, const cv::Rect& hole,
                              int step = 1) {
  FineHistogram histogram(kFineRgbBinCount, 0.0);
  for (int y = part.y; y < part.y + part.height; y += step) {
    const auto* row = bgr.ptr<cv::Vec3b>(y);
    for (int x = part.x; x < part.x + part.width; x += step) {
      if (!hole.contains({x, y})) {
        histogram[fineRgbBin(row[x][0], row[x][1], row[x][2])] += 1.0;
      }
    }
  }
  conclude(histogram);
  return histogram;
}

} // namespace

cv::Rect clippedToImage(const ImageBox& box, const cv::Mat& image) {
  const int left = static_cast<int>(std::lround(box.x));
  const int top = static_cast<int>(std::lround(box.y));
  const int right = static_cast<int>(std::lround(box.x + box.width));
  const int bottom = static_cast<int>(std::lround(box.y + box.height));
  return cv::Rect(left, top, right - left, bottom - top) & cv::Rect({0, 0}, image.size());
}

FineHistogram fineHistogramOf(const cv::Mat& bgr, const cv::Rect& part) {
  return histogramAround(bgr, part, {});
}

FineHistogram centralHistogramOf(const cv::Mat& bgr, const ImageBox& box) {
  FineHistogram histogram(kFineRgbBinCount, 0.0);
  const cv::Rect part = clippedToImage(box, bgr);
  for (int y = part.y; y < part.y + part.height; ++y) {
    const auto* row = bgr.ptr<cv::Vec3b>(y);
    const double down = (y + 0.5 - box.center().y()) / (0.5 * box.height);
    for (int x = part.x; x < part.x + part.width; ++x) {
      const double across = (x + 0.5 - box.center().x()) / (0.5 * box.width);
      histogram[fineRgbBin(row[x][0], row[x][1], row[x][2])] +=
          std::max(0.0, 1.0 - across * across - down * down);
    }
  }
  conclude(histogram);
  return histogram;
}

FineHistogram surroundingsHistogramOf(const cv::Mat& bgr, const ImageBox& box) {
  const ImageBox grown =
      ImageBox::around(box.center(), (1.0 + 2.0 * kBackgroundRing) * box.width + 2.0 * kRingPx,
                       (1.0 + 2.0 * kBackgroundRing) * box.height + 2.0 * kRingPx);
  const cv::Rect hole = clippedToImage(box, bgr);
  FineHistogram near = histogramAround(bgr, clippedToImage(grown, bgr), hole);
  const FineHistogram all = histogramAround(bgr, {{0, 0}, bgr.size()}, hole, kElsewhereStep);
  for (std::size_t bin = 0; bin < near.size(); ++bin) {
    near[bin] = (1.0 - kElsewhere) * near[bin] + kElsewhere * all[bin];
  }
  return near;
}

} // namespace dewpoint::observation
