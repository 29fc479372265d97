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

/// Instant of a scenario that shows well what a method can do.
struct PeopleInstant {
  std::int64_t frame = 0;
  std::string words; ///< description, such as "nearest to each other, 3.4 s"
};

/// Returns the instants to show as images: before people meet, when most of them are present and
/// they are closest to each other, and when identities are assessed. A scenario that does not
/// compare identities between two instants has only the second one.
std::vector<PeopleInstant> instantsToShow(const PeopleScenario& scenario);

/// Draws an image (CV_8UC3) like figure 2 of Mohedano et al. 2009. It contains the images of all
/// cameras, two per row, with the outlines of the 95 % volumes. It also contains the floor from
/// above, with the level curves of each person's density and the person's identity. White crosses
/// mark people (`truth`), and rings mark cameras.
cv::Mat drawPeopleImage(const PeopleFinding& people, const FrameSet& frames, const CameraRig& rig,
                        std::span<const TrackPoint> truth);

} // namespace dewpoint::experiment
