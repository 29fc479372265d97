// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/region/color_region.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <tuple>

namespace dewpoint::observation {
namespace {

/// Pixels by which each piece is grown for finding what belongs together: gaps of twice as much are
/// the noise and the compression of an image. A judgment (docs/method-dewpoint.md, section 12).
constexpr int kGrowth = 2;
/// Second moment of a pixel, a unit square, px².
constexpr double kPixelMoment = 1.0 / 12.0;

/// Sums over the pixels of a region, relative to the window's corner.
struct Sums {
  double count = 0.0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  int left = 0;
  int top = 0;
  int right = -1;
  int bottom = -1;
  int rimPixelCount = 0;
  int cut = 0;
  int hidden = 0;

  void add(int column, int row) {
    if (count == 0.0) {
      left = right = column;
      top = row;
    }
    left = std::min(left, column);
    right = std::max(right, column);
    bottom = row;
    const double x = column;
    const double y = row;
    count += 1.0;
    first += Eigen::Vector2d(x, y);
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }

  ColorRegion region(const cv::Point& corner) const {
    ColorRegion result;
    result.area = count;
    const Eigen::Vector2d mean = first / count;
    result.centroid = mean + Eigen::Vector2d(corner.x, corner.y);
    result.covariance << xx / count, xy / count, xy / count, yy / count;
    result.covariance -= mean * mean.transpose();
    result.covariance.diagonal().array() += kPixelMoment;
    result.box = {corner.x + left, corner.y + top, right - left + 1, bottom - top + 1};
    result.rimPixelCount = rimPixelCount;
    result.cutRimPixelCount = cut;
    result.hiddenRimPixelCount = hidden;
    return result;
  }
};

/// What ends a region at a pixel that is not its own.
void countRim(const LabelImage& labels, int column, int row, Sums& sums) {
  bool rim = false;
  bool cut = false;
  bool hidden = false;
  for (const auto& [right, down] :
       {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)}) {
    const int x = column + right;
    const int y = row + down;
    if (x < 0 || y < 0 || x >= labels.size().width || y >= labels.size().height) {
      rim = cut = true;
      continue;
    }
    const PixelLabel label = labels.at(x, y);
    rim = rim || label != PixelLabel::Target;
    hidden = hidden || label == PixelLabel::Unknown || label == PixelLabel::Explained;
  }
  sums.rimPixelCount += rim ? 1 : 0;
  sums.cut += cut ? 1 : 0;
  sums.hidden += !cut && hidden ? 1 : 0;
}

} // namespace

std::vector<ColorRegion> findRegions(LabelImage& labels, const cv::Rect& window, double leastArea) {
  const cv::Rect whole(cv::Point(0, 0), labels.size());
  const cv::Rect area = window & whole;
  if (area.empty()) {
    return {};
  }
  // With the neighbors of the pixels at its edge.
  labels.ensureLabels({area.x - 1, area.y - 1, area.width + 2, area.height + 2});
  cv::Mat mask;
  cv::compare(labels.labels()(area), static_cast<int>(PixelLabel::Target), mask, cv::CMP_EQ);
  cv::Mat grown;
  cv::dilate(mask, grown, cv::Mat::ones(2 * kGrowth + 1, 2 * kGrowth + 1, CV_8UC1));
  cv::Mat pieces;
  const int count = cv::connectedComponents(grown, pieces, 8, CV_32S);
  std::vector<Sums> sums(static_cast<std::size_t>(count));
  for (int row = 0; row < area.height; ++row) {
    const auto* matches = mask.ptr<std::uint8_t>(row);
    const auto* piece = pieces.ptr<std::int32_t>(row);
    for (int column = 0; column < area.width; ++column) {
      if (matches[column] != 0) {
        Sums& own = sums[static_cast<std::size_t>(piece[column])];
        own.add(column, row);
        countRim(labels, area.x + column, area.y + row, own);
      }
    }
  }
  std::vector<ColorRegion> regions;
  for (const Sums& own : sums) {
    if (own.count >= std::max(1.0, leastArea)) {
      regions.push_back(own.region(area.tl()));
    }
  }
  std::ranges::sort(regions, {}, [](const ColorRegion& region) {
    return std::tuple(-region.area, region.centroid.y(), region.centroid.x());
  });
  return regions;
}

ColorRegion joined(const ColorRegion& one, const ColorRegion& other) {
  ColorRegion result;
  result.area = one.area + other.area;
  const double share = other.area / result.area;
  const Eigen::Vector2d apart = other.centroid - one.centroid;
  result.centroid = one.centroid + share * apart;
  result.covariance = (1.0 - share) * one.covariance + share * other.covariance +
                      share * (1.0 - share) * apart * apart.transpose();
  result.box = one.box | other.box;
  result.rimPixelCount = one.rimPixelCount + other.rimPixelCount;
  result.cutRimPixelCount = one.cutRimPixelCount + other.cutRimPixelCount;
  result.hiddenRimPixelCount = one.hiddenRimPixelCount + other.hiddenRimPixelCount;
  return result;
}

} // namespace dewpoint::observation
