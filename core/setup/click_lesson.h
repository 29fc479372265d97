// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/color/color_learning.h"
#include "core/geometry/camera.h"
#include "core/project/project.h"
#include "core/setup/counterpart_search.h"
#include "core/setup/marked_part.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace dewpoint::setup {

/// The images that clicks are explained by: of one instant, in the order of the rig, CV_8UC3, empty
/// where there is none.
struct ClickedImages {
  std::vector<cv::Mat> images;
  std::vector<cv::Mat> emptyRooms; ///< as learnColorWithBackground()
  std::int64_t frame = 0;          ///< that they show
};

/// The outline of what was found in the image of a camera, pixels.
struct FoundOutline {
  int camera = 0;
  std::vector<cv::Point> outline;
};

/// What clicks on a target teach.
struct ClickLesson {
  LearnedColor color;
  std::vector<ColorSample> samples; ///< those that were clicked, then those that were found
  std::vector<FoundOutline> found;  ///< in the images shown
  /// Meters, as Counterparts::radius; nothing when nothing was found in the images shown.
  std::optional<double> radius;
  /// The centers of what shows the target in the images shown, where several cameras do: of the
  /// first click that was found elsewhere too.
  std::vector<PointClick> centers;
  /// The target, where what was marked is a part of something larger of its color: a box within it,
  /// or a click on something larger than the radius that is known. `radius` is that of the part.
  std::optional<MarkedPart> part;
  /// Where the target is in this frame: nothing unless the color alone does not say which object is
  /// meant, as others match too or it is a part of one.
  std::optional<PositionCorrection> correction;
};

/// How a radius compares with the one that clicks show, good to a third.
enum class RadiusFit : std::uint8_t {
  Fits,
  IsDiameter, ///< it is about twice as large: the diameter may be meant
  Differs,
};
RadiusFit compareRadius(double given, double shown);

/// The color of a target from samples of it: learned by what was clicked, and by what the cameras
/// in which it was not clicked show of the same object (findCounterparts()). For each click in the
/// images shown the other cameras are searched again; what was found of clicks in other frames
/// stays, as long as there is such a click.
///
/// `others` are samples of other targets. What the images show of one of about the same color is
/// neither this target nor background: two alike are told apart by where they are. One of another
/// color is background. Errors as learnColor().
Result<ClickLesson> learnFromClicks(const CameraRig& rig, const ClickedImages& shown,
                                    const std::vector<ColorSample>& samples,
                                    const CounterpartLimits& limits = {},
                                    const std::vector<ColorSample>& others = {});

/// The same for a target of a project (index in Project::targets; none: a new one): with its
/// cameras and volume of interest, the target's radius, and the samples of its other targets. Only
/// this one makes a correction.
Result<ClickLesson> learnFromClicks(const Project& project, int target, const ClickedImages& shown,
                                    const std::vector<ColorSample>& samples);

/// Gives a target of a project (index) what was learned: color, samples, the radius of a part
/// unless one is given, and the correction unless there is one of this frame. Corrections in frames
/// of clicks that are not among the samples any more are removed: they may have been of another
/// object.
void applyLesson(const ClickLesson& lesson, std::size_t target, Project& project);

/// The samples without one of them. One that was found is not forgotten but excluded: it would be
/// found again.
std::vector<ColorSample> withoutSample(std::vector<ColorSample> samples, std::size_t index);

/// Whether one of them was clicked on the target.
bool anyClicked(const std::vector<ColorSample>& samples);

} // namespace dewpoint::setup
