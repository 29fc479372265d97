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

/// An instant of a scenario that shows what a method can do.
struct PeopleInstant {
  std::int64_t frame = 0;
  std::string words; ///< "nearest to each other, 3.4 s"
};

/// Before people meet, when most of them are there and they are nearest to each other, and when
/// identities are assessed; of a scenario that assesses none between two instants, only the second.
std::vector<PeopleInstant> tellingInstants(const PeopleScenario& scenario);

/// As Mohedano et al. 2009, figure 2: the images of all cameras with the outlines of the 95 %
/// volumes, two beside each other, and the floor from above with the level curves of each person's
/// density and its identity; white crosses and rings: where people (`truth`) and cameras are.
/// CV_8UC3.
cv::Mat peoplePicture(const PeopleFinding& people, const FrameSet& frames, const CameraRig& rig,
                      std::span<const TrackPoint> truth);

} // namespace dewpoint::experiment
