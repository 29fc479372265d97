// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"
#include "core/experiment/metrics/track_frame.h"
#include "core/experiment/scenarios/people/people_scenario.h"
#include "core/tracking/tracker_capabilities.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Instant of a scenario that shows the abilities of a method.
struct PeopleInstant {
  std::int64_t frame = 0;
  std::string words; ///< "nearest to each other, 3.4 s"
};

/// Instants for pictures: before people meet; when most of them are present and they are nearest to
/// each other; and when identities are assessed. A scenario that does not assess identities between
/// two instants has only the second one.
std::vector<PeopleInstant> tellingInstants(const PeopleScenario& scenario);

/// Draws a picture like figure 2 of Mohedano et al. 2009. It has the images of all cameras with the
/// outlines of the 95 % volumes, two per row, and the floor from above with the level curves of
/// each person's density and its identity. White crosses mark people (`truth`), rings mark cameras.
/// CV_8UC3.
cv::Mat peoplePicture(const PeopleFinding& people, const FrameSet& frames, const CameraRig& rig,
                      std::span<const TrackPoint> truth);

} // namespace dewpoint::experiment
