// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/office_instant.h"

namespace dewpoint::experiment {
namespace {

std::vector<cv::Mat> silhouettesIn(const OfficeRenderer& renderer, std::size_t camera,
                                   std::int64_t frame) {
  std::vector<cv::Mat> all;
  all.reserve(renderer.scene().people.size());
  for (std::size_t person = 0; person < renderer.scene().people.size(); ++person) {
    all.push_back(renderer.silhouette(camera, frame, person));
  }
  return all;
}

} // namespace

OfficeInstant renderInstant(const PeopleRecording& recording, const OfficeRenderer& renderer,
                            std::int64_t frame) {
  const OfficeScene& scene = renderer.scene();
  OfficeInstant instant;
  instant.seeingCameraCounts.assign(scene.people.size(), 0);
  instant.frames = recording.frames(frame);
  for (std::size_t k = 0; k < scene.cameras.size(); ++k) {
    const cv::Mat who = renderer.visiblePeopleMask(k, frame);
    for (std::size_t person = 0; person < scene.people.size(); ++person) {
      const bool seen = cv::countNonZero(who == static_cast<int>(person + 1)) >= kMinVisiblePixels;
      instant.seeingCameraCounts[person] += seen ? 1 : 0;
    }
    instant.personIndexImages.push_back(who);
    if (frame % kSilhouetteInterval == 0) {
      instant.silhouettes.push_back(silhouettesIn(renderer, k, frame));
    }
  }
  return instant;
}

} // namespace dewpoint::experiment
