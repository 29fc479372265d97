// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/people/people_painter.h"
#include "core/simulation/sensor/shutter.h"

#include <opencv2/core.hpp>

#include <functional>
#include <vector>

namespace dewpoint::simulation {

/// Function that returns the body parts of each person at a time (seconds), one list per person,
/// for paintPeople().
using PeopleAt = std::function<std::vector<std::vector<BodyPart>>(double time)>;

/// Part of the time during which the shutter is open for at least one row of the image.
struct ExposureStep {
  double centerTime = 0.0; ///< center of the step, seconds from the frame's time
  /// Fraction of each row's exposure that falls into this step. The sum over all steps is 1.
  std::vector<float> rowShares;
};

/// Divides the time during which the shutter is open for at least one row into equal steps, in
/// order of time. The steps are so short that a walking person moves by at most one pixel in a
/// step.
std::vector<ExposureStep> exposureSteps(const Shutter& shutter, int rows);

/// Draws people as a camera with this shutter records them in a frame at `light.lightField.time`.
/// Each row collects light during its own exposure, so moving people appear blurred, and also
/// slanted with a rolling shutter. `image` (CV_32FC3) shows the room at this time. `light`
/// illuminates the people and the shadows that they cast.
void paintPeopleThroughShutter(const RoomView& view, const PeopleAt& people,
                               const PeopleLight& light, const Shutter& shutter, cv::Mat& image);

} // namespace dewpoint::simulation
