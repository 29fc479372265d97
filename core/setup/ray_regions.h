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

/// An object as the camera in which it was clicked shows it: where it may be, and how large it is
/// there.
struct ClickedObject {
  std::size_t camera = 0;
  Eigen::Vector2d center = Eigen::Vector2d::Zero(); ///< of its region, pixels
  Ray ray;                                          ///< through it
  double radiusPx = 0.0;                            ///< of a circle of the region's area
  double focal = 0.0;                               ///< of the camera, pixels

  /// Meters, at a depth in meters along the ray.
  double radiusAt(double depth) const { return radiusPx * depth / focal; }
  Eigen::Vector3d positionAt(double depth) const { return ray.origin + depth * ray.direction; }
  double depthOf(const Eigen::Vector3d& position) const {
    return (position - ray.origin).dot(ray.direction);
  }
  /// Pixels, in the image of another camera, when the object is at a position of its ray.
  double radiusPxIn(const Camera& camera, const Eigen::Vector3d& position) const;

  /// Pixels, standard deviation: how far from the image of a position, seen with this radius (px),
  /// the center of the object's region may be. Calibrations err by `kDirectionSigma`; the object
  /// moves between the exposures, and each camera sees another side of it.
  static double centerSigma(const Camera& camera, double radiusPx);
  static constexpr double kDirectionSigma = 0.0061; ///< radians: 0.25 degrees for each camera
  static constexpr double kCenterSigmaRadii = 0.35; ///< a judgment
  /// Standard deviations up to which something is searched for: 99.7 % of a normal distribution.
  static constexpr double kReach = 3.0;
};

/// The geometric mean of both focal lengths, pixels.
double focalOf(const Camera& camera);

/// The object of a sample in its camera's image (CV_8UC3); nothing when nothing of an object's size
/// grows there, or the lens shows nothing at it.
std::optional<ClickedObject> clickedObject(const Camera& camera, const cv::Mat& image,
                                           const ColorSample& sample);

/// A region of one image, as a click on `seed` grows it.
struct RayRegion {
  cv::Point seed;
  cv::Mat mask;                                     ///< CV_8UC1 of the image's size, 255 in it
  Eigen::Vector2d center = Eigen::Vector2d::Zero(); ///< pixels
  double area = 0.0;                                ///< pixels
  double logRatio = 0.0; ///< mean of its pixels, OtherCameraLikelihood, nats
};

/// The regions, at most eight, of another camera's image (CV_8UC3) that may show the object: grown
/// from where its color is likeliest, near the image of its ray at the depths that are possible.
std::vector<RayRegion> regionsAlongRay(const ClickedObject& object, const Camera& camera,
                                       const cv::Mat& image,
                                       const color::OtherCameraLikelihood& likelihood,
                                       const std::function<bool(double depth)>& isPossible);

} // namespace dewpoint::setup
