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

/// Minimum number of visible pixels at which a camera counts as seeing a person. It is a quarter of
/// a fully visible adult, who has 600 or more pixels.
inline constexpr int kMinVisiblePixels = 150;
/// Number of frames between two comparisons of silhouettes. Chosen to correspond to a third of a
/// second.
inline constexpr std::int64_t kSilhouetteInterval = 5;

/// One frame of a scene with people: its images as methods receive them, and the people that the
/// cameras really see at the time of the frame.
struct OfficeInstant {
  FrameSetPtr frames; ///< images as methods receive them: delayed, or null where dropped
  /// Number of cameras that see a person, that is, at least kMinVisiblePixels of the person; one
  /// number per person.
  std::vector<int> seeingCameraCounts;
  /// One image per camera: 1 + index of the person visible at each pixel, or 0; see paintPeople().
  std::vector<cv::Mat> personIndexImages;
  /// Complete silhouettes, indexed by camera, then by person. Empty in frames in which silhouettes
  /// are not compared.
  std::vector<std::vector<cv::Mat>> silhouettes;

  /// Returns the visible pixels of a person in a camera (CV_8UC1, nonzero where visible).
  cv::Mat visibleMask(std::size_t camera, std::size_t person) const {
    return personIndexImages[camera] == static_cast<int>(person + 1);
  }
};

/// Renders one frame. `renderer` must have been created from the scene and views of `recording`.
OfficeInstant renderInstant(const PeopleRecording& recording, const OfficeRenderer& renderer,
                            std::int64_t frame);

} // namespace dewpoint::experiment
