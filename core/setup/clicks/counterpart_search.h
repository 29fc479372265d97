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
  /// At most one sample per other camera, in camera order, with ColorSample::isFoundByGeometry set.
  /// Each sample is a region of the image that lies on the projected ray of the click and has the
  /// size and approximately the color expected there. The regions of all cameras agree on one
  /// position.
  std::vector<ColorSample> samples;
  /// Outlines of these regions in the images, in the order of `samples`, in pixels.
  std::vector<std::vector<cv::Point>> outlines;
  /// Centers of the click's region and of the regions found; empty if none was found.
  std::vector<PointClick> centers;
  /// Per camera, CV_8UC1 of its image's size: 255 where the object may be, although no region was
  /// identified as the object. These pixels must not be learned as background. Empty if there are
  /// none.
  std::vector<cv::Mat> undecidedMasks;
  /// Radius, in meters, of a ball that would appear as large as the regions found and the region of
  /// the click. Empty if none was found. It is accurate to about one third, since regions end where
  /// the color ends.
  std::optional<double> radius;
};

/// Known properties of the object in addition to the click.
struct CounterpartLimits {
  double radius = 0.0; ///< radius of the object, meters; 0 if unknown
  /// Volume in which the object may be, meters, world frame; empty: anywhere.
  std::optional<WorldBox> volume = {};
  /// Regions in images of the same frame that do not show the object.
  std::vector<ColorSample> excludedSamples = {};
};

/// Searches the images of all other cameras for the object of a sample that was clicked in the
/// image of one camera and is not excluded. `images` are all of one frame (CV_8UC3; empty for a
/// camera without an image).
///
/// In each camera, regions are grown along the projection of the click's ray (regionsAlongRay()). A
/// position where the rays of the click and of a region meet is weighted with the images of all
/// cameras: by the likelihood of the regions' color, their distances from the expected position,
/// and the differences in size. A region is accepted only if no other explanation of its image is
/// nearly as good. One of the explanations considered is that the object is hidden in this image.
/// If nothing is found with a known radius, the search is repeated as if the radius were unknown.
/// Nothing is found in cameras without a calibration (no focal length, or a calibration for another
/// image size).
Counterparts findCounterparts(const CameraRig& rig, const std::vector<cv::Mat>& images,
                              const ColorSample& sample, const CounterpartLimits& limits = {});

} // namespace dewpoint::setup
