// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/color/color_learning.h"
#include "core/geometry/camera.h"
#include "core/project/project.h"
#include "core/setup/clicks/counterpart_search.h"
#include "core/setup/clicks/marked_part.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace dewpoint::setup {

/// Images that the clicks refer to, all of one frame: CV_8UC3, in the order of the rig, empty for a
/// camera without an image.
struct ClickedImages {
  std::vector<cv::Mat> images;
  /// For each camera, the scene without targets, as for learnColorWithBackground().
  std::vector<cv::Mat> backgroundImages;
  std::int64_t frame = 0; ///< number of the frame that the images show
};

/// Outline of an object found in the image of a camera, in pixels.
struct FoundOutline {
  int camera = 0;
  std::vector<cv::Point> outline;
};

/// Result of learning from clicks on a target.
struct ClickLearningResult {
  LearnedColor color;
  std::vector<ColorSample> samples;   ///< the clicked samples, then those found in other images
  std::vector<FoundOutline> outlines; ///< outlines found in the displayed images
  /// Radius of the target in meters, derived from its size in the images (Counterparts::radius);
  /// empty if nothing was found in the displayed images.
  std::optional<double> radius;
  /// Centers of the target in the displayed images, for the first click whose object was also found
  /// in another camera; otherwise empty.
  std::vector<PointClick> centers;
  /// Position and size of the target if the user marked only a part of a larger object of its
  /// color: with a box inside the object, or with a click on an object larger than the known
  /// radius. `radius` above is then that of the part.
  std::optional<MarkedPart> part;
  /// Position of the target in this frame. Set only if the color alone does not identify the
  /// target, because other objects have this color or the target is a part of a larger object.
  std::optional<PositionCorrection> correction;
};

/// Comparison of the radius that the user entered with the radius derived from clicks. The radius
/// derived from clicks is accurate to about one third.
enum class RadiusFit : std::uint8_t {
  Fits,
  IsDiameter, ///< the entered value is about twice as large, so it may be the diameter
  Differs,
};
/// Compares the radius that the user entered (`given`) with the radius derived from clicks
/// (`shown`), in the same unit.
RadiusFit compareRadius(double given, double shown);

/// Learns the color of a target from samples: from those that the user clicked, and from samples of
/// the same object in cameras in which it was not clicked (findCounterparts()). For each click in
/// the displayed images, the other cameras are searched again. Samples found for clicks in other
/// frames are kept as long as those clicks exist.
///
/// `others` are samples of other targets. Another target of about the same color counts neither as
/// this target nor as background, since identical targets are distinguished by position. A target
/// of a different color counts as background. Returns the errors of learnColor().
Result<ClickLearningResult> learnFromClicks(const CameraRig& rig, const ClickedImages& shown,
                                            const std::vector<ColorSample>& samples,
                                            const CounterpartLimits& limits = {},
                                            const std::vector<ColorSample>& others = {});

/// Learns the color of a target of a project from samples that the user clicked, and from samples
/// found in other cameras. `target` is an index in Project::targets; if it is out of range, the
/// target is new. The cameras, the volume of interest, the radius and the samples of other targets
/// come from the project. Also sets ClickLearningResult::correction, which the overload without a
/// project leaves empty.
Result<ClickLearningResult> learnFromClicks(const Project& project, int target,
                                            const ClickedImages& shown,
                                            const std::vector<ColorSample>& samples);

/// Stores the result of learning in the target with index `target` of a project: its color, its
/// samples and its correction. An existing correction of the target in the same frame is kept,
/// unless the new one locates a part of an object with more clicks. If the result is about a part
/// of an object, the radius of the part is also stored, unless the target already has a radius.
/// Corrections in frames whose clicks are no longer among the samples are removed, since they may
/// belong to another object.
void applyLearningResult(const ClickLearningResult& result, std::size_t target, Project& project);

/// Returns the samples without one of them. An automatically found sample is marked as excluded,
/// since it would be found again if removed.
std::vector<ColorSample> withoutSample(std::vector<ColorSample> samples, std::size_t index);

/// Returns whether at least one sample was clicked on the target.
bool hasClickedSample(const std::vector<ColorSample>& samples);

} // namespace dewpoint::setup
