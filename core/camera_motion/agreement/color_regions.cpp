// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera_motion/agreement/color_regions.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <utility>

namespace dewpoint::camera_motion {
namespace {

// Chosen on tuning seeds of the suite's scenarios; pixels of the image.
constexpr int kRows = 120;          ///< of an image that are looked at, about
constexpr int kGap = 2;             ///< between runs of one row that are one
constexpr int kShortest = 2;        ///< of a run: one pixel alone is noise
constexpr double kLeastArea = 20.0; ///< pixels²
constexpr double kJoined = 1.2;     ///< sums of radii up to which two regions are one object's
/// Parts that do not hang together in the rows above, from which on the color is that of a texture
/// rather than of a target, and nothing is reported.
constexpr std::size_t kClutter = 400;
constexpr double kPixelSigma = 0.7;  ///< of any region
constexpr double kRowSigma = 0.3;    ///< of the distance between rows
constexpr double kRoundSigma = 0.03; ///< radii, of a round one: shading
constexpr double kRound = 1.1;       ///< ratio of axes that noise and motion blur give a disc
/// Radii by what that ratio is more: half a disc has 1.9, and its center is off by 0.42 radii.
constexpr double kLongSigma = 0.5;
/// Of the ellipse of its second moments, a disc fills all; what is missing makes it uncertain.
constexpr double kFilled = 0.95;
constexpr double kHollowSigma = 1.5;
constexpr double kWorstSigma = 1.0; ///< radii, of a region cut by the border, too

} // namespace

void ColorRegionSearch::Sums::add(const Sums& other) {
  left = area > 0.0 ? std::min(left, other.left) : other.left;
  right = area > 0.0 ? std::max(right, other.right) : other.right;
  top = area > 0.0 ? std::min(top, other.top) : other.top;
  bottom = area > 0.0 ? std::max(bottom, other.bottom) : other.bottom;
  area += other.area;
  x += other.x;
  y += other.y;
  xx += other.xx;
  yy += other.yy;
  xy += other.xy;
}

double ColorRegionSearch::Sums::radius() const {
  return std::sqrt(area / std::numbers::pi);
}

std::size_t ColorRegionSearch::rootOf(std::size_t part) {
  while (parents_[part] != part) {
    parents_[part] = parents_[parents_[part]];
    part = parents_[part];
  }
  return part;
}

void ColorRegionSearch::scanRow(const cv::Mat& image, int row, int step) {
  classifier_.matchRow(image.ptr<std::uint8_t>(row), image.cols, match_.data());
  here_.clear();
  const std::uint8_t* const begin = match_.data();
  const std::uint8_t* const end = begin + image.cols;
  for (const std::uint8_t* at = begin; at < end;) {
    const auto* first = static_cast<const std::uint8_t*>(
        std::memchr(at, 255, static_cast<std::size_t>(end - at))); // most rows have none
    if (first == nullptr) {
      break;
    }
    const auto* last = std::find(first, end, std::uint8_t{0});
    const int left = static_cast<int>(first - begin);
    const int right = static_cast<int>(last - begin) - 1;
    if (!here_.empty() && left - here_.back().right <= kGap) {
      here_.back().right = right;
    } else {
      here_.push_back({left, right, 0});
    }
    at = last;
  }
  std::erase_if(here_, [](const Run& run) { return run.right - run.left + 1 < kShortest; });
  auto candidate = above_.begin();
  for (Run& run : here_) {
    run.part = parents_.size();
    while (candidate != above_.end() && candidate->right + 1 < run.left) {
      ++candidate;
    }
    for (auto over = candidate; over != above_.end() && over->left <= run.right + 1; ++over) {
      const std::size_t root = rootOf(over->part);
      if (run.part == parents_.size()) {
        run.part = root;
      } else {
        const std::size_t own = rootOf(run.part);
        if (own != root) {
          sums_[own].add(sums_[root]);
          sums_[root] = {};
          parents_[root] = own;
        }
      }
    }
    if (run.part == parents_.size()) {
      parents_.push_back(run.part);
      sums_.emplace_back();
    }
    const double count = run.right - run.left + 1;
    const double middle = 0.5 * (run.left + run.right);
    const double pixels = count * step;
    Sums own;
    own.area = pixels;
    own.x = pixels * middle;
    own.y = pixels * row;
    own.xx = pixels * (middle * middle + count * count / 12.0);
    own.yy = pixels * row * row;
    own.xy = pixels * middle * row;
    own.left = run.left;
    own.right = run.right;
    own.top = own.bottom = row;
    sums_[rootOf(run.part)].add(own);
  }
  std::swap(above_, here_);
}

void ColorRegionSearch::mergeNearRegions() {
  for (std::size_t i = 0; i < sums_.size(); ++i) {
    for (std::size_t j = i + 1; j < sums_.size();) {
      const double reach = kJoined * (sums_[i].radius() + sums_[j].radius());
      if ((sums_[i].center() - sums_[j].center()).norm() < reach) {
        sums_[i].add(sums_[j]);
        sums_.erase(sums_.begin() + static_cast<std::ptrdiff_t>(j));
        j = i + 1; // it reaches farther now
      } else {
        ++j;
      }
    }
  }
}

ColorRegion ColorRegionSearch::regionOf(const Sums& sums, const cv::Mat& image, int step) const {
  const Eigen::Vector2d center = sums.center();
  const double radius = sums.radius();
  // Points on every few rows vary less than the pixels between them do.
  const double xx = sums.xx / sums.area - center.x() * center.x();
  const double yy = sums.yy / sums.area - center.y() * center.y() + step * step / 12.0;
  const double xy = sums.xy / sums.area - center.x() * center.y();
  const double mean = 0.5 * (xx + yy);
  const double half = std::hypot(0.5 * (xx - yy), xy);
  const double least = std::max(mean - half, 1.0 / 12.0);
  const double ratio = std::sqrt((mean + half) / least);
  const double filled = sums.area / (4.0 * std::numbers::pi * std::sqrt((mean + half) * least));
  const bool cut = sums.left <= 0 || sums.top < step || sums.right >= image.cols - 1 ||
                   sums.bottom + step >= image.rows;
  const double byShape =
      cut ? kWorstSigma
          : std::min(kWorstSigma, kRoundSigma + kLongSigma * std::max(0.0, ratio - kRound) +
                                      kHollowSigma * std::max(0.0, kFilled - filled));
  const double bias = byShape * radius;
  return {center, radius, std::hypot(kPixelSigma, kRowSigma * step, bias), bias};
}

const std::vector<ColorRegion>& ColorRegionSearch::find(const cv::Mat& image) {
  regions_.clear();
  if (image.type() != CV_8UC3 || image.empty()) {
    return regions_;
  }
  const int step = std::max(1, image.rows / kRows);
  match_.resize(static_cast<std::size_t>(image.cols));
  above_.clear();
  parents_.clear();
  sums_.clear();
  for (int row = step / 2; row < image.rows; row += step) {
    scanRow(image, row, step);
    if (parents_.size() > kClutter) {
      return regions_;
    }
  }
  std::erase_if(sums_, [](const Sums& sums) { return sums.area < kLeastArea; });
  std::ranges::stable_sort(sums_, std::ranges::greater(), &Sums::area);
  constexpr std::size_t kMostParts = 4 * kMaxRegions; // of which regions are joined
  sums_.resize(std::min(sums_.size(), kMostParts));
  mergeNearRegions();
  std::ranges::stable_sort(sums_, std::ranges::greater(), &Sums::area);
  sums_.resize(std::min(sums_.size(), kMaxRegions));
  for (const Sums& sums : sums_) {
    regions_.push_back(regionOf(sums, image, step));
  }
  return regions_;
}

} // namespace dewpoint::camera_motion
