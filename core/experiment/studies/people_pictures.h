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

/// Frame of a scenario at which an image shows well how a method performs.
struct PeopleInstant {
  std::int64_t frame = 0;
  std::string caption; ///< description, such as "nearest to each other, 3.4 s"
};

/// Returns the frames to show as images: one before people meet, the one in which most people are
/// present and they are closest to each other, and the one after the meeting at which identities
/// are compared. If a scenario does not compare identities, only the second of these frames is
/// returned.
std::vector<PeopleInstant> chooseInstantsToShow(const PeopleScenario& scenario);

/// Draws an image (CV_8UC3) like figure 2 of Mohedano et al. 2009. It contains the images of all
/// cameras, two per row, with the outlines of the 95 % volumes. It also contains the floor from
/// above, with the identity of each person and level curves of the probability density of the
/// person's position. White crosses mark the true positions of people (`truth`), and rings mark
/// cameras.
cv::Mat drawPeopleImage(const PeopleFinding& people, const FrameSet& frames, const CameraRig& rig,
                        std::span<const TrackPoint> truth);

} // namespace dewpoint::experiment
