// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/wand_collector.h"
#include "core/setup/calibration/wand_refinement.h"
#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <mutex>

namespace dewpoint::tests {
namespace {

using test::eventually;
using test::FakeRecording;
using test::inputs;

std::vector<ColorClassifier> pink() {
  return wandColorClassifiers(test::twoCameraProject(), WandOptions()).value();
}

TEST(WandCollector, SeesWhatLookingThroughTheRecordingSees) {
  FakeRecording recording({});
  WandViews expected(2, pink());
  WandCollector collector(2, pink());
  while (const FrameSetPtr frames = recording.next().value()) {
    expected.add(*frames);
    collector.offer(frames);
  }
  ASSERT_TRUE(eventually([&] { return collector.state().searchedFrameSetCount == 12; }));
  const auto views = collector.views();
  ASSERT_EQ(views[1].size(), 12U); // one still disc in each of the recording's frames
  for (std::size_t k = 0; k < views[1].size(); ++k) {
    EXPECT_EQ(views[1][k].pixel, expected.views()[1][k].pixel);
    EXPECT_EQ(views[1][k].time, expected.views()[1][k].time);
  }
  const auto state = collector.state();
  EXPECT_EQ(state.droppedFrameSetCount, 0);
  EXPECT_NEAR(state.durationSeconds, 11.0 / 30.0, 1e-6); // of twelve frames at 30 per second
  EXPECT_EQ(state.cameras[0].detectionCount, 12U);
  // The disc is in the middle of the image, whose regions are 6 x 4: region (3, 2), or the one
  // beside it; all twelve in the same.
  EXPECT_EQ(*std::ranges::max_element(state.cameras[0].imageCoverage.cornerCounts), 12);
  EXPECT_FALSE(hasEnoughDetections(state.cameras[0]));
}

TEST(WandCollector, DropsAndCountsWhatItCannotHold) {
  // Offered faster than anyone can look: images of 12 megapixels.
  auto set = std::make_shared<FrameSet>();
  const cv::Mat large(3000, 4000, CV_8UC3, cv::Scalar(60, 60, 60));
  set->frames = {std::make_shared<const Frame>(Frame{0, timeStamp(0.0), large}), nullptr};
  WandCollector collector(2, pink());
  for (std::size_t k = 0; k < 3 * WandCollector::kMaxWaitingFrameSets; ++k) {
    collector.offer(set);
  }
  const auto state = collector.state();
  EXPECT_GT(state.droppedFrameSetCount, 0);
  EXPECT_LE(state.waitingFrameSetCount,
            static_cast<std::int64_t>(WandCollector::kMaxWaitingFrameSets) +
                1); // and the one looked at
}

TEST(FrameTap, IsGivenEveryFrameTakenOnce) {
  Session session(inputs());
  ASSERT_TRUE(test::showsFrame(session)); // frame 0 was taken
  std::mutex mutex;
  std::vector<std::int64_t> given;
  session.setFrameTap([&](const FrameSetPtr& frames) {
    const std::lock_guard lock(mutex);
    given.push_back(frames->index);
  });
  session.play();
  ASSERT_TRUE(test::reaches(session, PlayState::Ended));
  session.rerunFrom(4); // tracked again, but not given again
  session.setMasksShown(true);
  ASSERT_TRUE(eventually([&] { return !session.newest()->masks.empty(); }));
  session.setFrameTap({});
  const std::lock_guard lock(mutex);
  EXPECT_EQ(given, (std::vector<std::int64_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
}

} // namespace
} // namespace dewpoint::tests
