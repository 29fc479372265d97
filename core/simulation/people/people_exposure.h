// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/people/people_painter.h"
#include "core/simulation/sensor/shutter.h"

#include <opencv2/core.hpp>

#include <functional>
#include <vector>

namespace dewpoint::simulation {

/// The parts of everybody at a time, seconds; see paintPeople().
using PeopleAt = std::function<std::vector<std::vector<BodyPart>>(double time)>;

/// A part of the time for which a shutter is open.
struct ExposureStep {
  double time = 0.0;         ///< its center, seconds from the frame's time
  std::vector<float> shares; ///< of each row's exposure that falls into it; over all steps: 1
};

/// Steps in which somebody who walks moves by a pixel or less, in the order of time.
std::vector<ExposureStep> exposureSteps(const Shutter& shutter, int rows);

/// Draws people as paintPeople() does in all of the light, as a shutter sees them whose frame is
/// taken at `light.field.time`: each row collects light for its own exposure, so that those who
/// move are blurred, and slanted by a rolling shutter. `image` (CV_32FC3): the room at that time.
void exposePeople(const RoomView& view, const PeopleAt& people, const PeopleLight& light,
                  const Shutter& shutter, cv::Mat& image);

} // namespace dewpoint::simulation
