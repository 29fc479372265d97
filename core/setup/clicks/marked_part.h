// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/manual/measured_points.h"
#include "core/color/color_sample.h"
#include "core/filter/gaussian.h"
#include "core/geometry/camera.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>
#include <vector>

namespace dewpoint::setup {

/// A part of a larger object of one color, such as a hand on an arm of the same color, that the
/// user marked in an image with a click or a box.
struct PartMark {
  ColorSample wholeObject; ///< sample of the whole object, as obtained by a click on the part
  /// Center of the largest disc of the color that fits into the part, in pixels; its radius is
  /// `radiusPx`.
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radiusPx = 0.0;
};

/// Returns the marked part if a box contains only a part of an object: at most kMaxBoxedFraction of
/// the pixels of the region grown from the center of the box in the image (CV_8UC3). Returns
/// nothing for a box around a whole object, and for a click.
std::optional<PartMark> partInBox(const cv::Mat& bgr, const ColorSample& box);
/// Returns the marked part if a disc of radius `radiusPx` covers at most kMaxClickedFraction of the
/// clicked object; the part has the size of this disc. Returns nothing for a click on a smaller
/// object, and for a box.
std::optional<PartMark> partAtClick(const cv::Mat& bgr, const ColorSample& click, double radiusPx);

/// A box marks only a part of an object if it contains at most this fraction of the object's
/// pixels. Estimate: a user who draws a box around a whole object omits little of it.
inline constexpr double kMaxBoxedFraction = 0.8;
/// A click marks only a part of an object if the disc of the given radius has at most this fraction
/// of the object's area. Estimate: a radius given for the whole object may be too small by a factor
/// of up to 1.6 (compareRadius()), so the area by a factor of up to 2.6, and 1 / 2.6 is about 0.4.
inline constexpr double kMaxClickedFraction = 0.4;

/// Position and size, in the world, of a part of an object that the user marked.
struct MarkedPart {
  Gaussian3 position;             ///< position (m, m²), world frame
  double radius = 0.0;            ///< radius of a ball that fits into the colored region, meters
  std::vector<PointClick> clicks; ///< centers of the user's marks, in pixels of their images
};

/// Returns the position of the part from its marks, at most one per camera, in images of one frame
/// (CV_8UC3, in the order of the rig, empty for a camera without an image). With several marks, it
/// is the point where the rays through their centers meet. With one mark, it is on the ray of this
/// mark, at the distance of the whole object. The other cameras determine this distance (`found`,
/// see findCounterparts()). The covariance then covers the extent of the whole object. Returns
/// nothing if the rays do not meet, or no other camera shows the whole object on the ray.
std::optional<MarkedPart> locatePart(const CameraRig& rig, const std::vector<cv::Mat>& images,
                                     const std::vector<PartMark>& marks,
                                     const std::vector<ColorSample>& found);

} // namespace dewpoint::setup
