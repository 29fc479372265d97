// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/manual/measured_points.h"
#include "core/color/color_sample.h"
#include "core/geometry/camera.h"
#include "core/geometry/world_box.h"

#include <opencv2/core/mat.hpp>

#include <optional>
#include <vector>

namespace dewpoint::setup {

/// What the other cameras show of an object that was clicked in one of them.
struct Counterparts {
  /// At most one sample per other camera, in their order, with `found` set: a region on the click's
  /// ray, as large as the object would be there and of about its color, in all cameras together at
  /// one position. The outlines of their regions, pixels, are in the same order.
  std::vector<ColorSample> found;
  std::vector<std::vector<cv::Point>> outlines;
  /// The centers of the click's region and of those that were found; empty when none was found.
  std::vector<PointClick> centers;
  /// Per camera, CV_8UC1 of its image's size: 255 where the object may be though nothing there was
  /// found to be it, so that it is no background either. Empty where everything is decided.
  std::vector<cv::Mat> undecided;
  /// Meters, of a ball as large as the regions that were found and that of the click; nothing when
  /// none was found. Good to a third: regions end where the color does.
  std::optional<double> radius;
};

/// What is known of the object besides the click.
struct CounterpartLimits {
  double radius = 0.0;                 ///< meters; 0 when unknown
  std::optional<WorldBox> volume = {}; ///< meters, world: where it may be
  /// Places in images of the same instant that do not show it.
  std::vector<ColorSample> excluded = {};
};

/// Searches the images of the other cameras (CV_8UC3; empty where there is none), all of one
/// instant, for the object of a sample that was taken in one of them and is not excluded.
///
/// In each camera regions are grown along the image of the click's ray (regionsAlongRay()). A
/// position where the click and a region meet is weighed by what all cameras show there: how likely
/// the region's color is, how far it lies from where it should be, and how much larger or smaller
/// it is. A region is found when nothing else explains its image nearly as well, the object being
/// hidden there included. Where nothing is found of the radius that is known, the object is
/// searched for as if it were not. Cameras without a calibration (no focal length, or that of
/// another image size) find nothing.
Counterparts findCounterparts(const CameraRig& rig, const std::vector<cv::Mat>& images,
                              const ColorSample& sample, const CounterpartLimits& limits = {});

} // namespace dewpoint::setup
