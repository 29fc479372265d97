// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_sample.h"
#include "core/color/likelihood/other_camera_likelihood.h"
#include "core/geometry/camera.h"
#include "core/geometry/ray.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace dewpoint::setup {

/// A clicked object as seen by its camera: its possible positions, and its size at each.
struct ClickedObject {
  std::size_t camera = 0;
  /// Center of the object's region in the image, pixels.
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  Ray ray;                    ///< ray from the camera through this center, world frame
  double radiusPx = 0.0;      ///< radius of a circle with the region's area, pixels
  double focalLengthPx = 0.0; ///< focal length of the camera, pixels

  /// Returns the radius of the object in meters if it is at a depth in meters along the ray.
  double radiusAt(double depth) const { return radiusPx * depth / focalLengthPx; }
  Eigen::Vector3d positionAt(double depth) const { return ray.origin + depth * ray.direction; }
  double depthOf(const Eigen::Vector3d& position) const {
    return (position - ray.origin).dot(ray.direction);
  }
  /// Returns the radius of the object in the image of another camera, in pixels, if the object is
  /// at `position` on the ray.
  double radiusPxIn(const Camera& camera, const Eigen::Vector3d& position) const;

  /// Returns the standard deviation, in pixels, of the distance between the center of an object's
  /// region of radius `radiusPx` and the projection of the object's position. The distance is not
  /// zero because calibrations have an error of `kDirectionSigma`, the object moves between the
  /// exposures, and each camera sees another side of it.
  static double centerSigma(const Camera& camera, double radiusPx);
  /// Error of two cameras together, radians: 0.25 degrees for each camera.
  static constexpr double kDirectionSigma = 0.0061;
  /// Part of centerSigma() that is caused by motion and by each camera seeing another side, as a
  /// fraction of the region's radius. Chosen by judgment.
  static constexpr double kCenterSigmaInRadii = 0.35;
  /// Largest deviation from the expected position or size, in standard deviations, at which regions
  /// are searched for. It covers 99.7 % of a normal distribution.
  static constexpr double kSearchSigmas = 3.0;
};

/// Returns the geometric mean of the horizontal and the vertical focal length of a camera, in
/// pixels.
double meanFocalLength(const Camera& camera);

/// Returns the object of a sample in its camera's image (CV_8UC3). Returns nothing if no region
/// that may be an object grows from the sample, or if the lens does not cover the center of the
/// region.
std::optional<ClickedObject> findClickedObject(const Camera& camera, const cv::Mat& image,
                                               const ColorSample& sample);

/// Region of an image, grown as if the user had clicked on `seedPixel`.
struct RayRegion {
  cv::Point seedPixel;
  cv::Mat mask; ///< CV_8UC1 of the image's size, 255 inside the region
  Eigen::Vector2d center = Eigen::Vector2d::Zero(); ///< center of the region, pixels
  double areaPx = 0.0;                              ///< number of pixels in the region
  /// Mean log likelihood ratio of the pixel colors: target against everything else, nats.
  double meanLogLikelihoodRatio = 0.0;
};

/// Returns at most eight regions of another camera's image (CV_8UC3) that may show the object. They
/// are grown from pixels near the projection of the object's ray that most probably have the color
/// of the object. Only depths for which `isPossible` returns true are considered.
std::vector<RayRegion> regionsAlongRay(const ClickedObject& object, const Camera& camera,
                                       const cv::Mat& image,
                                       const color::OtherCameraLikelihood& likelihood,
                                       const std::function<bool(double depth)>& isPossible);

} // namespace dewpoint::setup
