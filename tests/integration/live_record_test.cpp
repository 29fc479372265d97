// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of live cameras check with: whether they notice what must not be.
#include "tests/integration/image_tag.h"
#include "tests/integration/kept_track.h"
#include "tests/integration/watched_source.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace dewpoint::tests {
namespace {

/// An image as a fake camera sends it.
FramePtr taggedFrame(const ImageTag& tag, std::int64_t index, int width = 320) {
  Frame frame;
  frame.index = index;
  frame.captureTime = TimeStamp(1000 * (index + 1));
  frame.image = cv::Mat(240, width, CV_8UC3, cv::Scalar::all(90));
  drawTag(frame.image, tag);
  return std::make_shared<const Frame>(std::move(frame));
}

TEST(ImageTag, IsReadAsItWasDrawn) {
  for (const ImageTag& tag :
       {ImageTag{0, 0, true}, ImageTag{3, 123456, false}, ImageTag{7, 1, true}}) {
    const auto read = readTag(taggedFrame(tag, 0)->image);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->camera, tag.camera);
    EXPECT_EQ(read->tick, tag.tick);
    EXPECT_EQ(read->isGood, tag.isGood);
  }
  EXPECT_FALSE(readTag(cv::Mat::zeros(240, 320, CV_8UC3)));
  EXPECT_FALSE(readTag(cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(255))));
}

TEST(SetRecord, NamesWhatMustNotBe) {
  SetRecord record(320, 240);
  record.add({0, {}, {taggedFrame({0, 5, true}, 4), taggedFrame({1, 4, true}, 4)}});
  EXPECT_TRUE(record.faults().empty());
  EXPECT_EQ(record.completeSets(), 1);
  EXPECT_EQ(record.sets().at(0).good, 2);
  EXPECT_EQ(record.sets().at(0).tick, 5);
  record.add({1, {}, {nullptr, taggedFrame({0, 6, true}, 5)}});
  ASSERT_EQ(record.faults().size(), 1U);
  EXPECT_EQ(record.faults().back(), "camera 2, image 5: is of camera 1");
  EXPECT_EQ(record.completeSets(), 0);
  record.add({2, {}, {taggedFrame({0, 6, false}, 4), nullptr}});
  EXPECT_EQ(record.faults().back(), "camera 1, image 4: follows image 4");
  EXPECT_EQ(record.sets().at(2).good, 0);
  record.add({3, {}, {taggedFrame({0, 7, true}, 6, 640), nullptr}});
  EXPECT_EQ(record.faults().back(), "camera 1, image 6: 640 x 240, type 16");
}

TEST(KeptTrack, CountsOnlyFramesInWhichTwoCamerasShowTheTarget) {
  std::map<std::int64_t, SetRecord::Entry> sets;
  Trajectory trajectory;
  const auto add = [&](int good, std::int64_t tick, bool valid, double x) {
    const auto index = static_cast<std::int64_t>(sets.size());
    sets[index] = {good, good, tick};
    TrajectorySample& sample = trajectory.samples.emplace_back();
    sample.frame = index;
    sample.isValid = valid;
    sample.position = {x, 0.0, 0.0};
  };
  add(2, 0, false, 0.0); // the first of two: it may take time to find the target
  add(2, 1, true, 0.01);
  add(1, 2, false, 0.0); // one camera alone
  add(2, 3, false, 0.0);
  add(2, 4, false, 0.0);  // lost
  add(3, 5, true, 0.05);  // too far off
  add(3, 20, false, 0.0); // after an interruption
  const auto kept = keptTrack(
      sets, trajectory, [](std::int64_t) { return Eigen::Vector3d::Zero().eval(); }, 2, 0.03);
  EXPECT_EQ(kept.due, 3);
  ASSERT_EQ(kept.lost.size(), 2U);
  EXPECT_EQ(kept.lost[0], "frame 4, tick 4: 2 good of 2 images, not tracked, 0 mm from the truth");
  EXPECT_EQ(kept.lost[1], "frame 5, tick 5: 3 good of 3 images, tracked, 50 mm from the truth");
  EXPECT_DOUBLE_EQ(kept.largestError, 0.05);
}

} // namespace
} // namespace dewpoint::tests
