// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/clicks/ray_regions.h"

#include "core/color/color_region.h"
#include "core/color/likelihood/color_likelihood.h"
#include "core/geometry/projector.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace dewpoint::setup {
namespace {

// Judgments.

/// Regions that are weighed in each camera, and spots from which one is grown: some leak into the
/// room.
constexpr std::size_t kMostRegions = 8;
constexpr std::size_t kMostGrown = 16;
/// Depths along the ray, meters, each 1 % more than the one before: steps of less than a pixel.
constexpr double kNearest = 0.05;
constexpr double kFarthest = 100.0;
constexpr double kRayDepthStep = 1.01;
/// Side of the part of an image in which a region is grown, in radii of the object.
constexpr double kPartRadii = 16.0;
constexpr int kLeastPart = 32; ///< pixels
/// Share of an image that an object takes at most: what is larger is the room around it.
constexpr double kMostShare = 0.15;
/// Radii of the object between spots that are looked at.
constexpr double kSpotStepRadii = 0.25;
/// Half the side of a spot, in radii of the object: well within it.
constexpr double kSpotHalfRadii = 0.5;

/// A point of the ray in the image of another camera.
struct RayPoint {
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double radiusPx = 0.0; ///< that the object has there
};

std::vector<RayPoint> imageOfRay(const ClickedObject& object, const Camera& camera,
                                 const std::function<bool(double depth)>& isPossible) {
  const Projector projector(camera);
  const double margin =
      ClickedObject::kSearchSigmas * ClickedObject::kDirectionSigma * meanFocalLength(camera);
  const auto isNearImage = [&](const Eigen::Vector2d& pixel) {
    return pixel.x() > -margin && pixel.y() > -margin &&
           pixel.x() < camera.intrinsics.width + margin &&
           pixel.y() < camera.intrinsics.height + margin;
  };
  std::vector<RayPoint> points;
  for (double depth = kNearest; depth < kFarthest; depth *= kRayDepthStep) {
    const Eigen::Vector3d position = object.positionAt(depth);
    const auto pixel = isPossible(depth) ? projector.project(position) : std::nullopt;
    if (pixel && isNearImage(*pixel)) {
      points.push_back({*pixel, object.radiusPxIn(camera, position)});
    }
  }
  return points;
}

/// Means of log ratios over squares.
class LogRatioImage {
public:
  LogRatioImage(const cv::Mat& image, const color::ColorLikelihood& likelihood)
      : size_(image.size()) {
    cv::Mat steps(image.size(), CV_8SC1);
    for (int y = 0; y < image.rows; ++y) {
      likelihood.computeLogRatioRow(image.ptr<std::uint8_t>(y), image.cols,
                                    steps.ptr<std::int8_t>(y));
    }
    cv::Mat logRatios;
    steps.convertTo(logRatios, CV_32F, color::ColorLikelihood::kLogRatioStep);
    cv::integral(logRatios, sums_, CV_64F);
  }

  bool contains(const cv::Point& at) const { return cv::Rect({0, 0}, size_).contains(at); }
  double meanAround(const cv::Point& at, int half) const {
    const int left = std::max(0, at.x - half);
    const int top = std::max(0, at.y - half);
    const int right = std::min(size_.width, at.x + half + 1);
    const int bottom = std::min(size_.height, at.y + half + 1);
    const double sum = sums_.at<double>(bottom, right) - sums_.at<double>(top, right) -
                       sums_.at<double>(bottom, left) + sums_.at<double>(top, left);
    return sum / ((right - left) * (bottom - top));
  }

private:
  cv::Size size_;
  cv::Mat sums_;
};

/// A place of the image near the ray.
struct Spot {
  cv::Point at;
  double radiusPx = 0.0;
  double logRatio = 0.0; ///< less the farther it is from the ray
};

void addSpotsAcross(const RayPoint& point, const Eigen::Vector2d& along, const Camera& camera,
                    const LogRatioImage& image, std::vector<Spot>& spots) {
  const Eigen::Vector2d across(-along.y(), along.x());
  const double step = std::max(1.0, kSpotStepRadii * point.radiusPx);
  const double sigma = ClickedObject::centerSigma(camera, point.radiusPx);
  const int count = static_cast<int>(std::ceil(ClickedObject::kSearchSigmas * sigma / step));
  const int half = std::max(1, static_cast<int>(std::lround(kSpotHalfRadii * point.radiusPx)));
  for (int k = -count; k <= count; ++k) {
    const Eigen::Vector2d exact = point.pixel + k * step * across;
    const cv::Point at(static_cast<int>(std::lround(exact.x())),
                       static_cast<int>(std::lround(exact.y())));
    if (image.contains(at)) {
      const double off = k * step / sigma;
      spots.push_back({at, point.radiusPx, image.meanAround(at, half) - 0.25 * off * off});
    }
  }
}

/// The likeliest first.
std::vector<Spot> spotsNear(const std::vector<RayPoint>& points, const Camera& camera,
                            const LogRatioImage& image) {
  std::vector<Spot> spots;
  const RayPoint* last = nullptr;
  for (const RayPoint& point : points) {
    const double step = std::max(1.0, kSpotStepRadii * point.radiusPx);
    if (last == nullptr) {
      last = &point;
      addSpotsAcross(point, Eigen::Vector2d::UnitX(), camera, image, spots);
    } else if (const Eigen::Vector2d way = point.pixel - last->pixel; way.norm() >= step) {
      last = &point;
      addSpotsAcross(point, way.normalized(), camera, image, spots);
    }
  }
  std::ranges::stable_sort(spots, std::ranges::greater{}, &Spot::logRatio);
  return spots;
}

/// 255 where the object's region may be.
cv::Mat maskNear(const std::vector<RayPoint>& points, const Camera& camera) {
  cv::Mat mask = cv::Mat::zeros(camera.intrinsics.height, camera.intrinsics.width, CV_8UC1);
  for (const RayPoint& point : points) {
    const double reach =
        ClickedObject::kSearchSigmas * ClickedObject::centerSigma(camera, point.radiusPx) +
        point.radiusPx;
    cv::circle(mask,
               {static_cast<int>(std::lround(point.pixel.x())),
                static_cast<int>(std::lround(point.pixel.y()))},
               static_cast<int>(std::ceil(reach)), cv::Scalar(255), cv::FILLED);
  }
  return mask;
}

Eigen::Vector2d centerOf(const cv::Mat& mask) {
  const cv::Moments moments = cv::moments(mask, true);
  return {moments.m10 / moments.m00, moments.m01 / moments.m00};
}

bool isObject(double area, const cv::Mat& image) {
  return area > 0.0 && area <= kMostShare * static_cast<double>(image.total());
}

std::optional<RayRegion> grow(const Spot& spot, const cv::Mat& image, const cv::Mat& near,
                              const color::OtherCameraLikelihood& likelihood) {
  const int half = std::max(kLeastPart, static_cast<int>(kPartRadii * spot.radiusPx)) / 2;
  const cv::Rect part = cv::Rect(spot.at.x - half, spot.at.y - half, 2 * half + 1, 2 * half + 1) &
                        cv::Rect({0, 0}, image.size());
  const cv::Mat grown = color::growRegion(image(part), spot.at - part.tl());
  RayRegion region;
  region.areaPx = cv::countNonZero(grown);
  if (!isObject(region.areaPx, image)) {
    return std::nullopt;
  }
  region.seedPixel = spot.at;
  region.mask = cv::Mat::zeros(image.size(), CV_8UC1);
  grown.copyTo(region.mask(part));
  region.center = centerOf(region.mask);
  region.meanLogLikelihoodRatio = likelihood.meanLogLikelihoodRatio(image, near, region.mask);
  return region;
}

} // namespace

double meanFocalLength(const Camera& camera) {
  return std::sqrt(camera.intrinsics.focalX * camera.intrinsics.focalY);
}

double ClickedObject::radiusPxIn(const Camera& other, const Eigen::Vector3d& position) const {
  constexpr double kAtTheLens = 1e-6; // meters
  const double distance = std::max((position - other.center()).norm(), kAtTheLens);
  return radiusAt(depthOf(position)) * meanFocalLength(other) / distance;
}

double ClickedObject::centerSigma(const Camera& camera, double radiusPx) {
  // Two cameras' directions are compared.
  return std::hypot(kDirectionSigma * meanFocalLength(camera), kCenterSigmaInRadii * radiusPx);
}

std::optional<ClickedObject> findClickedObject(const Camera& camera, const cv::Mat& image,
                                               const ColorSample& sample) {
  const cv::Mat region = color::regionOfSample(image, sample);
  const int area = cv::countNonZero(region);
  if (!isObject(area, image)) {
    return std::nullopt;
  }
  const Eigen::Vector2d center = centerOf(region);
  const auto ray = Unprojector(camera).ray(center);
  if (!ray) {
    return std::nullopt;
  }
  return ClickedObject{static_cast<std::size_t>(sample.camera), center, *ray,
                       std::sqrt(area / std::numbers::pi), meanFocalLength(camera)};
}

std::vector<RayRegion> regionsAlongRay(const ClickedObject& object, const Camera& camera,
                                       const cv::Mat& image,
                                       const color::OtherCameraLikelihood& likelihood,
                                       const std::function<bool(double depth)>& isPossible) {
  const std::vector<RayPoint> points = imageOfRay(object, camera, isPossible);
  const cv::Mat near = maskNear(points, camera);
  const LogRatioImage logRatios(image, likelihood.likelihoodForImage(image, near));
  std::vector<RayRegion> regions;
  std::vector<cv::Point> grown;
  for (const Spot& spot : spotsNear(points, camera, logRatios)) {
    const auto isBeside = [&](const cv::Point& seed) {
      return cv::norm(seed - spot.at) < spot.radiusPx;
    };
    const auto isIn = [&](const RayRegion& region) {
      return region.mask.at<std::uint8_t>(spot.at) != 0;
    };
    if (std::ranges::any_of(grown, isBeside) || std::ranges::any_of(regions, isIn)) {
      continue;
    }
    if (regions.size() == kMostRegions || grown.size() == kMostGrown) {
      break;
    }
    grown.push_back(spot.at);
    if (auto region = grow(spot, image, near, likelihood)) {
      regions.push_back(std::move(*region));
    }
  }
  return regions;
}

} // namespace dewpoint::setup
