// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/people/people_painter.h"
#include "core/simulation/sensor/shutter.h"

#include <opencv2/core.hpp>

#include <functional>
#include <vector>

namespace dewpoint::simulation {

/// Returns the parts of all people at a time (seconds), see paintPeople().
using PeopleAt = std::function<std::vector<std::vector<BodyPart>>(double time)>;

/// Part of the time during which a shutter is open.
struct ExposureStep {
  double time = 0.0; ///< center of the step, seconds from the frame's time
  /// Fraction of each row's exposure that falls into this step. The sum over all steps is 1.
  std::vector<float> shares;
};

/// Returns steps in which a walking person moves by at most a pixel, in order of time.
std::vector<ExposureStep> exposureSteps(const Shutter& shutter, int rows);

/// Draws people like paintPeople() with all lights, as recorded by a shutter for a frame at
/// `light.field.time`. Each row collects light during its own exposure, so moving people appear
/// blurred, and also slanted with a rolling shutter. `image` (CV_32FC3) shows the room at that
/// time.
void paintPeopleThroughShutter(const RoomView& view, const PeopleAt& people,
                               const PeopleLight& light, const Shutter& shutter, cv::Mat& image);

} // namespace dewpoint::simulation
