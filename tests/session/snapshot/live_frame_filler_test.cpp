// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/snapshot/live_frame_filler.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

/// A live moment of two cameras; where `present` is false, a camera has no image.
std::shared_ptr<TrackSnapshot> trackedFrame(double time, bool first, bool second) {
  auto set = std::make_shared<FrameSet>();
  set->time = timeStamp(time);
  for (const bool present : {first, second}) {
    set->frames.push_back(present
                              ? std::make_shared<const Frame>(Frame{
                                    0, set->time, cv::Mat(2, 2, CV_8UC3, cv::Scalar(time, 0, 0))})
                              : nullptr);
  }
  auto snapshot = std::make_shared<TrackSnapshot>();
  snapshot->frames = set;
  return snapshot;
}

FramePtr frameOf(const TrackSnapshotPtr& snapshot, std::size_t camera) {
  return snapshot->frames->frames[camera];
}

TEST(LiveFrameFiller, ALateCameraShowsItsLastImage) {
  LiveFrameFiller filler;
  const auto both = trackedFrame(1.0, true, true);
  EXPECT_EQ(filler.withMissingImages(both).get(), both.get()); // nothing to fill: no copy
  auto one = trackedFrame(1.05, true, false);
  one->masks = {cv::Mat(2, 2, CV_8UC1), cv::Mat()};
  const auto seen = filler.withMissingImages(one);
  EXPECT_EQ(frameOf(seen, 0), frameOf(one, 0));
  EXPECT_EQ(frameOf(seen, 1), frameOf(both, 1));
  EXPECT_EQ(frameOf(one, 1), nullptr); // what was published stays as it was
  EXPECT_EQ(seen->masks.size(), 2U);
}

TEST(LiveFrameFiller, ASilentCameraIsMissing) {
  LiveFrameFiller filler;
  filler.withMissingImages(trackedFrame(1.0, true, true));
  const double young = LiveFrameFiller::kMaxImageAgeSeconds;
  EXPECT_NE(frameOf(filler.withMissingImages(trackedFrame(1.0 + 0.9 * young, true, false)), 1),
            nullptr);
  EXPECT_EQ(frameOf(filler.withMissingImages(trackedFrame(1.0 + young, true, false)), 1), nullptr);
  EXPECT_EQ(frameOf(filler.withMissingImages(trackedFrame(0.5, true, false)), 1),
            nullptr); // begun anew
}

TEST(LiveFrameFiller, RecordingsAndThePastAreShownAsTheyAre) {
  LiveFrameFiller filler;
  filler.withMissingImages(trackedFrame(1.0, true, true));
  auto recorded = trackedFrame(1.05, true, false);
  recorded->frameCount = 100;
  EXPECT_EQ(frameOf(filler.withMissingImages(recorded), 1), nullptr);
  auto past = trackedFrame(1.05, true, false);
  past->isPast = true;
  EXPECT_EQ(frameOf(filler.withMissingImages(past), 1), nullptr);
  EXPECT_EQ(filler.withMissingImages(nullptr), nullptr);
}

} // namespace
} // namespace dewpoint::tests
