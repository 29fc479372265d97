// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/region/region_measurement.h"

#include "core/observation/sphere/sphere_evidence.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace dewpoint::observation {
namespace {

// Judgments (docs/method-dewpoint.md, section 12).

/// Semi-axes within which regions are looked for first.
constexpr double kRegionReach = 1.8;
constexpr double kMarginPx = 6.0;
/// Factor by which that part grows while what belongs to the target goes on at its edge, and how
/// often it does.
constexpr double kRegionGrowth = 1.6;
constexpr int kMostGrowths = 6;
/// Squared distance between the centroids of two areas, by the sum of their second moments, up to
/// which they are parts of one: two halves of a stick have 0.6, two equal objects side by side 6.
constexpr double kSameObject = 3.0;
/// Least area of a piece, as a share of the expected outline's, and in pixels.
constexpr double kLeastRegionShare = 0.005;
constexpr double kLeastArea = 5.0;
/// The ring in which a target does not show its color, in semi-axes.
constexpr double kRegionRingBegin = 1.3;
constexpr double kRegionRingEnd = 1.8;
/// Share of the ring from which on it speaks against the target.
constexpr double kCleanRing = 0.2;
/// Share of the best evidence that a clean ring gives; the inside gives the rest.
constexpr double kRingShare = 0.1;
/// By how many times that share a ring full of the color speaks against the target.
constexpr double kFullRing = 9.0;
/// Logarithm of the ratio of the region's size to the outline's up to which they agree, and how
/// many times the best evidence a region speaks against the target that is e times as large as
/// that, and at most.
constexpr double kSizeTolerance = 0.35;
constexpr double kLargerShare = 1.5;
/// Pixels of area; smaller outlines count less, as SphereEvidence has it.
constexpr double kFullRegionArea = 60.0;

cv::Rect boxAround(const EllipseImage& ellipse, double reach, const Eigen::Matrix2d& more) {
  const Eigen::Vector2d half = reach * ellipse.extent.diagonal().cwiseSqrt() +
                               3.0 * more.diagonal().cwiseSqrt() +
                               Eigen::Vector2d::Constant(kMarginPx);
  const auto bounded = [](double value) {
    return static_cast<int>(std::lround(std::clamp(value, -1e6, 1e6)));
  };
  const int left = bounded(ellipse.center.x() - half.x());
  const int top = bounded(ellipse.center.y() - half.y());
  return {left, top, bounded(ellipse.center.x() + half.x()) - left + 1,
          bounded(ellipse.center.y() + half.y()) - top + 1};
}

bool goesOn(const ColorRegion& region, const cv::Rect& window, const cv::Rect& image) {
  const auto reaches = [](int own, int edge, int border) { return own == edge && edge != border; };
  return reaches(region.box.x, window.x, image.x) || reaches(region.box.y, window.y, image.y) ||
         reaches(region.box.br().x, window.br().x, image.br().x) ||
         reaches(region.box.br().y, window.br().y, image.br().y);
}

bool overlap(const EllipseImage& expected, const Eigen::Matrix2d& centerCovariance,
             const ColorRegion& region) {
  const Eigen::Vector2d off = region.centroid - expected.center;
  const Eigen::Matrix2d spread = 0.25 * expected.extent + centerCovariance + region.covariance;
  return off.dot(spread.inverse() * off) <= kSameObject;
}

/// All pieces that belong to the expected outline, as far as they go.
std::optional<ColorRegion> regionAt(LabelImage& labels, const EllipseImage& expected,
                                    const Eigen::Matrix2d& centerCovariance) {
  const cv::Rect image(cv::Point(0, 0), labels.size());
  const double least = std::max(kLeastArea, kLeastRegionShare * expected.area());
  std::optional<ColorRegion> all;
  double reach = kRegionReach;
  for (int growth = 0; growth <= kMostGrowths; ++growth, reach *= kRegionGrowth) {
    const cv::Rect window = boxAround(expected, reach, centerCovariance) & image;
    all.reset();
    for (const ColorRegion& region : findRegions(labels, window, least)) {
      if (overlap(expected, centerCovariance, region)) {
        all = all ? joined(*all, region) : region;
      }
    }
    if (!all || !goesOn(*all, window, image)) {
      break;
    }
  }
  return all;
}

/// Fills in what is inside the outline and in the ring around it.
void countPixels(LabelImage& labels, RegionMeasurement& measurement) {
  const EllipseImage& expected = measurement.expectedOutline;
  const cv::Rect image(cv::Point(0, 0), labels.size());
  const cv::Rect area = boxAround(expected, kRegionRingEnd, Eigen::Matrix2d::Zero()) & image;
  labels.ensureLabels(area);
  const Eigen::Matrix2d inverse = expected.extent.inverse();
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double visible = 0.0;
  double matched = 0.0;
  double known = 0.0;
  double ring = 0.0;
  for (int row = area.y; row < area.y + area.height; ++row) {
    for (int column = area.x; column < area.x + area.width; ++column) {
      const Eigen::Vector2d off = Eigen::Vector2d(column, row) - expected.center;
      const double squared = off.dot(inverse * off);
      if (squared > kRegionRingEnd * kRegionRingEnd) {
        continue;
      }
      const PixelLabel label = labels.at(column, row);
      if (label == PixelLabel::Unknown || label == PixelLabel::Explained) {
        continue;
      }
      const double match = label == PixelLabel::Target ? 1.0 : 0.0;
      if (squared <= 1.0) {
        sum += off;
        visible += 1.0;
        matched += match;
      } else if (squared >= kRegionRingBegin * kRegionRingBegin) {
        known += 1.0;
        ring += match;
      }
    }
  }
  // An outline of few pixels may hold a pixel more than its area.
  measurement.visibleShare = std::min(1.0, visible / std::max(1.0, expected.area()));
  measurement.matchedShare = visible > 0.0 ? matched / visible : 0.0;
  measurement.ringMatchShare = known > 0.0 ? ring / known : 0.0;
  measurement.centerFromVisible =
      visible > 0.0 ? Eigen::Vector2d(-sum / visible) : Eigen::Vector2d(0.0, 0.0);
}

/// Logarithm of how much larger, as a length, the region is than the outline; what is hidden makes
/// it smaller, but nothing larger.
double excess(const RegionMeasurement& measurement) {
  if (!measurement.region) {
    return 0.0;
  }
  const double seen = 16.0 * measurement.region->covariance.determinant();
  return 0.25 * std::log(std::max(seen, 1e-12) / measurement.expectedOutline.extent.determinant());
}

} // namespace

RegionMeasurement measureRegion(LabelImage& labels, const EllipseImage& expected,
                                const Eigen::Matrix2d& centerCovariance) {
  RegionMeasurement result;
  result.expectedOutline = expected;
  if (labels.empty()) {
    return result;
  }
  result.isInView = expected.center.x() >= 0.0 && expected.center.y() >= 0.0 &&
                    expected.center.x() <= labels.size().width - 1 &&
                    expected.center.y() <= labels.size().height - 1;
  countPixels(labels, result);
  result.region = regionAt(labels, expected, centerCovariance);
  return result;
}

double fullRegionEvidence() {
  return SphereEvidence::maxLogLikelihoodRatio();
}

double regionEvidence(const RegionMeasurement& measurement, double fill) {
  const double share = std::min(1.0, measurement.expectedOutline.area() / kFullRegionArea);
  const double seen = std::min(1.0, measurement.matchedShare / std::max(fill, 1e-3));
  const double inside = measurement.visibleShare * (2.0 * seen - 1.0);
  const double ring = std::max(-kFullRing, (kCleanRing - measurement.ringMatchShare) / kCleanRing) *
                      measurement.visibleShare;
  const double size = std::clamp(excess(measurement) - kSizeTolerance, 0.0, 1.0) * kLargerShare;
  return share * fullRegionEvidence() * ((1.0 - kRingShare) * inside + kRingShare * ring - size);
}

} // namespace dewpoint::observation
