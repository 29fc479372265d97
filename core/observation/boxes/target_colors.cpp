// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/boxes/target_colors.h"

#include "core/color/rgb_bins.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::observation {
namespace {

/// P(target | color) where a color is q of the target and b of its surroundings: of the target's
/// colors alone, of each half before anything is known, and sharper by the squares.
double shareOf(double q, double b) {
  const double target = (q + kChanceShare) * (q + kChanceShare);
  const double around = (b + kChanceShare) * (b + kChanceShare);
  return target / (target + around);
}

/// How far it is above a half, in [0, 1]: what is as frequent around speaks for nothing.
double excessOf(double q, double b) {
  return std::max(0.0, 2.0 * shareOf(q, b) - 1.0);
}

/// Factor by which learned colors may be scaled: they are assumed to be at most half ground. Origin
/// not recorded.
constexpr double kMostGrown = 2.0;
/// Weight of the first image in the reference, 0 to 1. Origin not recorded.
constexpr double kAnchor = 0.5;
} // namespace

ImageBox TargetColors::partOf(const ImageBox& box, int part) {
  const double width = box.width / kColumnCount;
  const double height = box.height / kRowCount;
  const int column = part % kColumnCount;
  const int row = part / kColumnCount;
  return {box.x + column * width, box.y + row * height, width, height};
}

void TargetColors::learn(const cv::Mat& bgr, const ImageBox& box) {
  for (int part = 0; part < kPartCount; ++part) {
    first_[std::size_t(part)] = fineHistogramOf(bgr, clippedToImage(partOf(box, part), bgr));
  }
  parts_ = first_;
  surroundings_ = surroundingsHistogramOf(bgr, box);
}

/// The colors of some pixels without those that are rather the surroundings' than the reference's:
/// each counts by q / (q + b).
FineHistogram TargetColors::figureOf(FineHistogram now, const FineHistogram& reference) const {
  double left = 0.0;
  for (std::size_t bin = 0; bin < now.size(); ++bin) {
    const double q = reference[bin] + kChanceShare;
    now[bin] *= q / (q + surroundings_[bin] + kChanceShare);
    left += now[bin];
  }
  const double grown = left > 0.0 ? std::min(kMostGrown, 1.0 / left) : 0.0;
  for (double& share : now) {
    share *= grown;
  }
  return now;
}

void TargetColors::adaptTarget(const cv::Mat& bgr, const ImageBox& box, double rate) {
  for (int part = 0; part < kPartCount; ++part) {
    const cv::Rect pixels = clippedToImage(partOf(box, part), bgr);
    if (pixels.empty()) {
      continue; // outside the image: nothing is known of it
    }
    FineHistogram& reference = parts_[std::size_t(part)];
    const FineHistogram now = figureOf(fineHistogramOf(bgr, pixels), reference);
    const FineHistogram& anchor = first_[std::size_t(part)];
    for (std::size_t bin = 0; bin < now.size(); ++bin) {
      const double wanted = (1.0 - kAnchor) * now[bin] + kAnchor * anchor[bin];
      reference[bin] += rate * (wanted - reference[bin]);
    }
  }
}

void TargetColors::adaptSurroundings(const cv::Mat& bgr, const ImageBox& box, double rate) {
  const FineHistogram now = surroundingsHistogramOf(bgr, box);
  for (std::size_t bin = 0; bin < now.size(); ++bin) {
    surroundings_[bin] += rate * (now[bin] - surroundings_[bin]);
  }
}

BinShares TargetColors::binShares(int part) const {
  const FineHistogram& reference = parts_[std::size_t(part)];
  BinShares shares(reference.size());
  for (std::size_t bin = 0; bin < reference.size(); ++bin) {
    const double excess = excessOf(reference[bin], surroundings_[bin]);
    shares[bin] = static_cast<std::uint16_t>(std::lround(excess * kFixedPointOne));
  }
  return shares;
}

double TargetColors::similarityOf(const cv::Mat& bgr, const ImageBox& box) const {
  double sum = 0.0;
  for (int part = 0; part < kPartCount; ++part) {
    const cv::Rect pixels = clippedToImage(partOf(box, part), bgr);
    const FineHistogram& reference = first_[std::size_t(part)];
    for (int y = pixels.y; y < pixels.y + pixels.height; ++y) {
      const auto* row = bgr.ptr<cv::Vec3b>(y);
      for (int x = pixels.x; x < pixels.x + pixels.width; ++x) {
        const std::size_t bin = fineRgbBin(row[x][0], row[x][1], row[x][2]);
        sum += excessOf(reference[bin], surroundings_[bin]);
      }
    }
  }
  return sum / box.area();
}

} // namespace dewpoint::observation
