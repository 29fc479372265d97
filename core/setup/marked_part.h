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

/// A mark on a part of something that is of one color and larger: on a hand, whose arm has its
/// color.
struct PartMark {
  ColorSample whole; ///< what a click on the part takes: the whole thing
  /// Of the largest disc of the color that fits there, pixels: the middle of the part.
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  double radiusPx = 0.0;
};

/// A box that holds only a part of what grows from its middle in the image (CV_8UC3): at most
/// kMostInBox of its pixels. Nothing for a box around a whole thing, and for a click.
std::optional<PartMark> boxedPart(const cv::Mat& bgr, const ColorSample& box);
/// A click on something of which a disc of this radius is at most kMostClicked: the part is as
/// large as that. Nothing for a click on something smaller, and for a box.
std::optional<PartMark> clickedPart(const cv::Mat& bgr, const ColorSample& click, double radiusPx);
/// Shares of the area of the whole thing that a part has at most. Judgments: who draws a box around
/// a thing leaves out little of it; radii are given wrongly by up to a factor of 1.6
/// (compareRadius()), which is one of 2.6 in area.
inline constexpr double kMostInBox = 0.8;
inline constexpr double kMostClicked = 0.4;

/// A part in the room.
struct MarkedPart {
  Gaussian3 position;             ///< m, m²; world
  double radius = 0.0;            ///< meters, of a ball that fits into the color there
  std::vector<PointClick> clicks; ///< the middles of the marks
};

/// Where the part is by its marks in images of one instant (CV_8UC3, in the order of the rig, empty
/// where there is none), at most one per camera. Several marks: where their rays meet. One mark:
/// somewhere on its ray, as far from the camera as the other cameras show the whole thing on it
/// (`found`, findCounterparts()); its covariance says how far that reaches. Nothing where rays do
/// not meet, or where no other camera shows the whole thing on the ray.
std::optional<MarkedPart> locatePart(const CameraRig& rig, const std::vector<cv::Mat>& images,
                                     const std::vector<PartMark>& marks,
                                     const std::vector<ColorSample>& found);

} // namespace dewpoint::setup
