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

/// Detections, in other cameras, of an object clicked in one camera.
struct Counterparts {
  /// At most one sample per other camera, in camera order, with `found` set: a region on the
  /// click's ray, of the size and about the color expected there, consistent with one position in
  /// all cameras. The outlines of the regions, in pixels, have the same order.
  std::vector<ColorSample> found;
  std::vector<std::vector<cv::Point>> outlines;
  /// Centers of the click's region and of the regions found; empty if none was found.
  std::vector<PointClick> centers;
  /// Per camera, CV_8UC1 of its image's size: 255 where the object may be although no region was
  /// identified as the object. These pixels do not count as background either. Empty if there are
  /// no such pixels.
  std::vector<cv::Mat> undecided;
  /// Radius in meters of a ball as large as the regions found and that of the click; empty if none
  /// was found. It is accurate to about one third, since regions end where the color ends.
  std::optional<double> radius;
};

/// Known properties of the object in addition to the click.
struct CounterpartLimits {
  double radius = 0.0;                 ///< meters; 0 if unknown
  std::optional<WorldBox> volume = {}; ///< meters, world frame: possible positions
  /// Regions in images of the same instant that do not show the object.
  std::vector<ColorSample> excluded = {};
};

/// Searches the images of the other cameras (CV_8UC3; empty for a camera without an image), all of
/// one instant, for the object of a sample that was clicked in one of them and is not excluded.
///
/// In each camera, regions are grown along the projection of the click's ray (regionsAlongRay()). A
/// position where the click and a region meet is weighted by the images of all cameras: the
/// likelihood of the region's color, its distance from the expected position, and the difference in
/// size. A region is accepted if no other explanation of its image is nearly as good, including
/// that the object is hidden there. If nothing is found with a known radius, the search is repeated
/// with an unknown one. Nothing is found in cameras without a calibration (no focal length, or a
/// calibration for another image size).
Counterparts findCounterparts(const CameraRig& rig, const std::vector<cv::Mat>& images,
                              const ColorSample& sample, const CounterpartLimits& limits = {});

} // namespace dewpoint::setup
