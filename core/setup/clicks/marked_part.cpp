// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/clicks/marked_part.h"

#include "core/color/color_region.h"
#include "core/geometry/projector.h"
#include "core/geometry/ray.h"
#include "core/setup/clicks/ray_regions.h"

#include <Eigen/LU>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

namespace dewpoint::setup {
namespace {

// Depths along a ray, meters, each 0.3 % more than the one before: steps of about a pixel.
constexpr double kNearestShown = 0.05;
constexpr double kFarthestShown = 100.0;
constexpr double kShownStep = 1.003;

/// The largest disc of a region (CV_8UC1) whose center is in `where`, no larger than `mostPx`; of
/// several the one nearest to `wanted`.
std::pair<cv::Point, double> largestDisc(const cv::Mat& region, const cv::Rect& where,
                                         const cv::Point& wanted, double mostPx) {
  cv::Mat padded; // the thing may go on beyond the image, but nobody sees it there
  cv::copyMakeBorder(region, padded, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::Mat distances;
  cv::distanceTransform(padded, distances, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  cv::Point best = wanted;
  double radius = 0.0;
  double off = 0.0;
  for (int y = where.y; y < where.y + where.height; ++y) {
    for (int x = where.x; x < where.x + where.width; ++x) {
      const double fits = std::min<double>(mostPx, distances.at<float>(y + 1, x + 1));
      const double away = std::hypot(x - wanted.x, y - wanted.y);
      if (fits > radius || (fits >= radius && away < off)) {
        best = {x, y};
        radius = fits;
        off = away;
      }
    }
  }
  return {best, radius};
}

std::optional<PartMark> markOf(const cv::Mat& bgr, const cv::Mat& region, const ColorSample& sample,
                               const cv::Point& at, const cv::Rect& where, double mostPx) {
  ColorSample whole = sample;
  whole.x = at.x;
  whole.y = at.y;
  whole.width = whole.height = 0.0;
  auto taken = color::takeSample(bgr, whole);
  const auto [center, radius] = largestDisc(region, where, at, mostPx);
  if (!taken || radius <= 0.0) {
    return std::nullopt;
  }
  return PartMark{std::move(*taken), {center.x, center.y}, radius};
}

cv::Point pixelOf(double x, double y, const cv::Mat& image) {
  return {std::clamp(static_cast<int>(std::lround(x)), 0, image.cols - 1),
          std::clamp(static_cast<int>(std::lround(y)), 0, image.rows - 1)};
}

/// A mark as a ray.
struct MarkRay {
  Ray ray;
  double spread = 0.0; ///< radius of the part per meter of depth

  Eigen::Vector3d at(double depth) const { return ray.origin + depth * ray.direction; }
  double depthOf(const Eigen::Vector3d& position) const {
    return (position - ray.origin).dot(ray.direction);
  }
  Eigen::Matrix3d along() const { return ray.direction * ray.direction.transpose(); }
};

/// Depths at which all of the regions show the ray.
std::vector<double> shownDepths(const CameraRig& rig, const MarkRay& ray,
                                const std::vector<std::pair<std::size_t, cv::Mat>>& regions) {
  std::vector<Projector> projectors;
  projectors.reserve(regions.size());
  for (const auto& [camera, region] : regions) {
    projectors.emplace_back(rig[camera]);
  }
  std::vector<double> depths;
  for (double depth = kNearestShown; depth < kFarthestShown; depth *= kShownStep) {
    bool shown = true;
    for (std::size_t i = 0; shown && i < regions.size(); ++i) {
      const auto pixel = projectors[i].project(ray.at(depth));
      const cv::Mat& region = regions[i].second;
      const cv::Point at = pixel ? cv::Point(static_cast<int>(std::lround(pixel->x())),
                                             static_cast<int>(std::lround(pixel->y())))
                                 : cv::Point(-1, -1);
      shown = cv::Rect({0, 0}, region.size()).contains(at) && region.at<std::uint8_t>(at) != 0;
    }
    if (shown) {
      depths.push_back(depth);
    }
  }
  return depths;
}

std::optional<Gaussian3> onRay(const MarkRay& ray, const std::vector<double>& depths) {
  if (depths.empty()) {
    return std::nullopt;
  }
  double sum = 0.0;
  for (const double depth : depths) {
    sum += depth;
  }
  const double mean = sum / static_cast<double>(depths.size());
  double variance = 0.0;
  for (const double depth : depths) {
    variance += (depth - mean) * (depth - mean) / static_cast<double>(depths.size());
  }
  const double across = ClickedObject::kCenterSigmaInRadii * ray.spread * mean;
  return Gaussian3{ray.at(mean),
                   across * across * Eigen::Matrix3d::Identity() + variance * ray.along()};
}

std::optional<Gaussian3> rayIntersection(const std::vector<MarkRay>& rays) {
  std::vector<Ray> lines;
  lines.reserve(rays.size());
  for (const MarkRay& ray : rays) {
    lines.push_back(ray.ray);
  }
  const auto point = nearestPoint(lines);
  if (!point) {
    return std::nullopt;
  }
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  for (const MarkRay& ray : rays) {
    const double sigma = ClickedObject::kCenterSigmaInRadii * ray.spread * ray.depthOf(*point);
    information += (Eigen::Matrix3d::Identity() - ray.along()) / (sigma * sigma);
  }
  const Eigen::Matrix3d covariance = information.inverse();
  return Gaussian3{*point, 0.5 * (covariance + covariance.transpose())};
}

} // namespace

std::optional<PartMark> partInBox(const cv::Mat& bgr, const ColorSample& box) {
  if (!box.isBox() || bgr.type() != CV_8UC3) {
    return std::nullopt;
  }
  const cv::Point middle = pixelOf(box.x + 0.5 * box.width, box.y + 0.5 * box.height, bgr);
  const cv::Rect within =
      cv::Rect(static_cast<int>(std::lround(box.x)), static_cast<int>(std::lround(box.y)),
               static_cast<int>(std::lround(box.width)),
               static_cast<int>(std::lround(box.height))) &
      cv::Rect({0, 0}, bgr.size());
  const cv::Mat region = color::growRegion(bgr, middle);
  const double inside = within.empty() ? 0 : cv::countNonZero(region(within));
  if (inside < color::kMinBoxFill * within.area() ||
      inside > kMaxBoxedFraction * cv::countNonZero(region)) {
    return std::nullopt;
  }
  return markOf(bgr, region, box, middle, within, 0.5 * std::min(within.width, within.height));
}

std::optional<PartMark> partAtClick(const cv::Mat& bgr, const ColorSample& click, double radiusPx) {
  if (click.isBox() || bgr.type() != CV_8UC3) {
    return std::nullopt;
  }
  const cv::Mat region = color::regionOfSample(bgr, click);
  if (std::numbers::pi * radiusPx * radiusPx > kMaxClickedFraction * cv::countNonZero(region)) {
    return std::nullopt;
  }
  const cv::Point at = pixelOf(click.x, click.y, bgr);
  const int reach = static_cast<int>(radiusPx);
  const cv::Rect where = cv::Rect(at.x - reach, at.y - reach, 2 * reach + 1, 2 * reach + 1) &
                         cv::Rect({0, 0}, bgr.size());
  return markOf(bgr, region, click, at, where, radiusPx);
}

std::optional<MarkedPart> locatePart(const CameraRig& rig, const std::vector<cv::Mat>& images,
                                     const std::vector<PartMark>& marks,
                                     const std::vector<ColorSample>& found) {
  std::vector<MarkRay> rays;
  MarkedPart part;
  for (const PartMark& mark : marks) {
    const Camera& camera = rig.at(static_cast<std::size_t>(mark.wholeObject.camera));
    if (const auto ray = Unprojector(camera).ray(mark.center)) {
      rays.push_back({*ray, mark.radiusPx / meanFocalLength(camera)});
      part.clicks.push_back({mark.wholeObject.camera, mark.center});
    }
  }
  std::optional<Gaussian3> position;
  if (rays.size() > 1) {
    position = rayIntersection(rays);
  } else if (rays.size() == 1) {
    std::vector<std::pair<std::size_t, cv::Mat>> regions;
    for (const ColorSample& sample : found) {
      const auto camera = static_cast<std::size_t>(sample.camera);
      if (sample.camera != part.clicks.front().camera) {
        regions.emplace_back(camera, color::regionOfSample(images.at(camera), sample));
      }
    }
    position = regions.empty() ? std::nullopt
                               : onRay(rays.front(), shownDepths(rig, rays.front(), regions));
  }
  if (!position) {
    return std::nullopt;
  }
  part.position = *position;
  double logRadius = 0.0;
  for (const MarkRay& ray : rays) {
    logRadius += std::log(ray.spread * ray.depthOf(position->mean));
  }
  part.radius = std::exp(logRadius / static_cast<double>(rays.size()));
  return part;
}

} // namespace dewpoint::setup
