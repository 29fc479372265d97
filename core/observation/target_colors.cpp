// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/target_colors.h"

#include "core/color/rgb_bins.h"

#include <cmath>
#include <numeric>

namespace dewpoint {
namespace {

/// Share of a bin's count that goes to each neighbor: a color lies anywhere in its bin, noise of a
/// few gray levels carries it over the edge.
constexpr double kToNeighbor = 0.25;
/// Shares this small are not told from chance: one pixel of a thousand.
constexpr double kChance = 1e-3;
/// How much the first image holds the reference back.
constexpr double kAnchor = 0.5;
/// The ring around a box that shows its surroundings: share of its sides, and pixels.
constexpr double kRing = 0.5;
constexpr double kRingPx = 8.0;
/// Share of the whole image in the surroundings: what the target may come to next.
constexpr double kElsewhere = 0.3;
constexpr int kElsewhereStep = 4; // pixels

cv::Rect pixelsOf(const ImageBox& box, const cv::Mat& image) {
  const int left = static_cast<int>(std::lround(box.x));
  const int top = static_cast<int>(std::lround(box.y));
  const int right = static_cast<int>(std::lround(box.x + box.width));
  const int bottom = static_cast<int>(std::lround(box.y + box.height));
  return cv::Rect(left, top, right - left, bottom - top) & cv::Rect({0, 0}, image.size());
}

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

/// Of the pixels of `part` that are not in `hole`, every `step`-th in both directions.
FineHistogram histogramOf(const cv::Mat& bgr, const cv::Rect& part, const cv::Rect& hole,
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
  const double sum = std::accumulate(histogram.begin(), histogram.end(), 0.0);
  for (double& share : histogram) {
    share = sum > 0.0 ? share / sum : 0.0;
  }
  smooth(histogram);
  return histogram;
}

FineHistogram surroundingsOf(const cv::Mat& bgr, const ImageBox& box) {
  const ImageBox grown =
      ImageBox::around(box.center(), (1.0 + 2.0 * kRing) * box.width + 2.0 * kRingPx,
                       (1.0 + 2.0 * kRing) * box.height + 2.0 * kRingPx);
  const cv::Rect hole = pixelsOf(box, bgr);
  FineHistogram near = histogramOf(bgr, pixelsOf(grown, bgr), hole);
  const FineHistogram all = histogramOf(bgr, {{0, 0}, bgr.size()}, hole, kElsewhereStep);
  for (std::size_t bin = 0; bin < near.size(); ++bin) {
    near[bin] = (1.0 - kElsewhere) * near[bin] + kElsewhere * all[bin];
  }
  return near;
}

} // namespace

ImageBox TargetColors::partOf(const ImageBox& box, int part) {
  const double width = box.width / kColumns;
  const double height = box.height / kRows;
  return {box.x + part % kColumns * width, box.y + part / kColumns * height, width, height};
}

void TargetColors::learn(const cv::Mat& bgr, const ImageBox& box) {
  for (int part = 0; part < kParts; ++part) {
    first_[std::size_t(part)] = histogramOf(bgr, pixelsOf(partOf(box, part), bgr), {});
  }
  parts_ = first_;
  surroundings_ = surroundingsOf(bgr, box);
}

void TargetColors::adaptTarget(const cv::Mat& bgr, const ImageBox& box, double rate) {
  for (int part = 0; part < kParts; ++part) {
    const cv::Rect pixels = pixelsOf(partOf(box, part), bgr);
    if (pixels.empty()) {
      continue; // outside the image: nothing is known of it
    }
    const FineHistogram now = histogramOf(bgr, pixels, {});
    FineHistogram& reference = parts_[std::size_t(part)];
    const FineHistogram& anchor = first_[std::size_t(part)];
    for (std::size_t bin = 0; bin < now.size(); ++bin) {
      const double wanted = (1.0 - kAnchor) * now[bin] + kAnchor * anchor[bin];
      reference[bin] += rate * (wanted - reference[bin]);
    }
  }
}

void TargetColors::adaptSurroundings(const cv::Mat& bgr, const ImageBox& box, double rate) {
  const FineHistogram now = surroundingsOf(bgr, box);
  for (std::size_t bin = 0; bin < now.size(); ++bin) {
    surroundings_[bin] += rate * (now[bin] - surroundings_[bin]);
  }
}

BinShares TargetColors::shares(int part) const {
  const FineHistogram& reference = parts_[std::size_t(part)];
  BinShares shares(reference.size());
  for (std::size_t bin = 0; bin < reference.size(); ++bin) {
    const double target = reference[bin] + kChance;
    const double around = surroundings_[bin] + kChance;
    const double share = target * target / (target * target + around * around);
    shares[bin] = static_cast<std::uint16_t>(std::lround(share * kWhole));
  }
  return shares;
}

} // namespace dewpoint
