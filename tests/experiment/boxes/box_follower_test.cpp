// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/boxes/box_clips.h"
#include "core/experiment/boxes/box_follower.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <filesystem>
#include <string>

namespace dewpoint::tests {
namespace {

constexpr double kSize = 30.0;

ImageBox boxAt(int frame) {
  return ImageBox::around({60.0 + 3.0 * frame, 80.0}, kSize, kSize);
}

/// A red disc with a darker rim that moves to the right over a blotchy gray wall.
cv::Mat imageAt(int frame) {
  cv::Mat image(160, 240, CV_8UC3);
  cv::RNG random(7);
  random.fill(image, cv::RNG::UNIFORM, 110, 140);
  cv::GaussianBlur(image, image, {7, 7}, 2.0);
  const Eigen::Vector2d center = boxAt(frame).center();
  const cv::Point2d at(center.x() - 0.5, center.y() - 0.5);
  cv::circle(image, at, 15, cv::Scalar(20, 20, 150), cv::FILLED);
  cv::circle(image, at, 10, cv::Scalar(40, 40, 230), cv::FILLED);
  return image;
}

/// Largest distance of the center from the truth, pixels; negative when the target was lost.
double worstErrorOf(BoxFollower& follower) {
  EXPECT_TRUE(follower.start(imageAt(0), boxAt(0)));
  double worst = 0.0;
  for (int frame = 1; frame < 25; ++frame) {
    const auto box = follower.step(imageAt(frame));
    if (!box) {
      return -1.0;
    }
    worst = std::max(worst, (box->center() - boxAt(frame).center()).norm());
  }
  return worst;
}

TEST(BoxFollower, OursAndTheTrackersOfOpenCvFollowAPlainDisc) {
  for (const std::string& name : boxFollowerNames()) {
    if (name == "kcf-box") {
      continue; // it does not follow a disc that changes its background
    }
    auto follower = makeFollowerByName(name, 300, 5);
    ASSERT_TRUE(follower) << name;
    const double worst = worstErrorOf(**follower);
    EXPECT_GE(worst, 0.0) << name << " has lost it";
    EXPECT_LT(worst, 10.0) << name;
  }
}

TEST(BoxFollower, OursStateHowSureTheyAreAndOpenCvsDoNot) {
  auto ours = makeDewpointFollower("histogram", 100, 3);
  ASSERT_TRUE(ours);
  worstErrorOf(**ours);
  ASSERT_TRUE((*ours)->confidence());
  EXPECT_GT((*ours)->confidence()->similarity, 0.5);
  EXPECT_TRUE((*ours)->confidence()->isVisible);
  for (const std::string& name : openCvFollowerNames()) {
    const auto peer = makeOpenCvFollower(name);
    ASSERT_NE(peer, nullptr) << name;
    worstErrorOf(*peer);
    EXPECT_FALSE(peer->confidence()) << name;
  }
}

TEST(BoxFollower, TheSameSeedGivesTheSameBoxes) {
  auto one = makeDewpointFollower("sugandi", 100, 3);
  auto other = makeDewpointFollower("sugandi", 100, 3);
  ASSERT_TRUE((*one)->start(imageAt(0), boxAt(0)));
  ASSERT_TRUE((*other)->start(imageAt(0), boxAt(0)));
  for (int frame = 1; frame < 10; ++frame) {
    EXPECT_EQ((*one)->step(imageAt(frame)), (*other)->step(imageAt(frame)));
  }
}

TEST(BoxFollower, AnUnknownNameIsNotFound) {
  const auto unknown = makeFollowerByName("medianflow-box", 100, 1);
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::NotFound);
}

TEST(BoxClips, ASimulatedClipHasItsBallInEachBox) {
  const BoxClip clip = simulatedBoxClip(41);
  ASSERT_EQ(clip.truth.size(), 300U);
  EXPECT_TRUE(clip.hasExactBoxes);
  for (const std::int64_t frame : {0, 100, 299}) {
    const auto image = clip.image(frame);
    ASSERT_TRUE(image);
    EXPECT_EQ(image->size(), cv::Size(320, 240));
    const Eigen::Vector2d center = clip.truth[static_cast<std::size_t>(frame)].center();
    // The ball is pink: more red than green at its middle.
    const cv::Mat patch = (*image)(cv::Rect(int(center.x()) - 2, int(center.y()) - 2, 5, 5));
    const cv::Scalar color = cv::mean(patch);
    EXPECT_GT(color[2], 1.3 * color[1]) << frame;
  }
}

TEST(BoxClips, AFolderWithoutRecordingsHasNone) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "no-clips";
  std::filesystem::create_directories(folder);
  const auto clips = recordedBoxClips(folder);
  ASSERT_TRUE(clips);
  EXPECT_TRUE(clips->empty());
}

} // namespace
} // namespace dewpoint::tests
