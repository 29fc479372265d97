// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"
#include "core/experiment/scenarios/people/people_recording.h"
#include "core/simulation/people/office.h"

#include <opencv2/core.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace dewpoint::experiment {

/// Pixels of a person in a camera that sees it (a whole adult: 600 and more);
/// chosen: a quarter of one.
inline constexpr int kVisiblePixels = 150;
/// Frames from one instant at which silhouettes are compared to the next; chosen: a
/// third of a second.
inline constexpr std::int64_t kSilhouetteEvery = 5;

/// One instant of a scene with people: its images, and who is seen by the true cameras at that
/// time, however late the images are.
struct OfficeInstant {
  FrameSetPtr frames;             ///< as they come, see PeopleRecording
  std::vector<int> camerasSeeing; ///< per person: how many see at least kVisiblePixels
  std::vector<cv::Mat> who;       ///< per camera: see paintPeople()
  /// Per camera, then per person: whole silhouettes; empty between the instants that are compared.
  std::vector<std::vector<cv::Mat>> silhouettes;

  /// CV_8UC1: not 0 where a person is seen in a camera.
  cv::Mat visible(std::size_t camera, std::size_t person) const {
    return who[camera] == static_cast<int>(person + 1);
  }
};

/// `renderer`: of the recording's scene and views.
OfficeInstant renderInstant(const PeopleRecording& recording, const OfficeRenderer& renderer,
                            std::int64_t frame);

} // namespace dewpoint::experiment
