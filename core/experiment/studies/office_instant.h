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

/// Least number of pixels of a person in a camera that sees the person (a whole adult has 600 or
/// more); chosen: a quarter of an adult.
inline constexpr int kVisiblePixels = 150;
/// Frames between two comparisons of silhouettes; chosen: a third of a second.
inline constexpr std::int64_t kSilhouetteEvery = 5;

/// One instant of a scene with people: its images, and the people whom the true cameras see at that
/// time, regardless of delays.
struct OfficeInstant {
  FrameSetPtr frames; ///< as they arrive, see PeopleRecording
  /// Per person: number of cameras that see at least kVisiblePixels.
  std::vector<int> camerasSeeing;
  std::vector<cv::Mat> who; ///< per camera: see paintPeople()
  /// Whole silhouettes per camera, then per person; empty between the compared instants.
  std::vector<std::vector<cv::Mat>> silhouettes;

  /// Visible pixels of a person in a camera (CV_8UC1, nonzero where visible).
  cv::Mat visible(std::size_t camera, std::size_t person) const {
    return who[camera] == static_cast<int>(person + 1);
  }
};

/// Renders an instant; `renderer` must be made from the recording's scene and views.
OfficeInstant renderInstant(const PeopleRecording& recording, const OfficeRenderer& renderer,
                            std::int64_t frame);

} // namespace dewpoint::experiment
