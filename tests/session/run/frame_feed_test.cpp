// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/frame_feed.h"
#include "tests/session/drawn_recording.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace dewpoint::tests {
namespace {

constexpr std::int64_t kFedFrames = 6;

/// The drawn recording's project, whose cameras have no names, with names.
Project namedProject(const std::string& method) {
  Project project = test::drawnInputs(method, kFedFrames).project;
  for (std::size_t k = 0; k < project.cameras.size(); ++k) {
    project.cameras[k].camera.name = "camera " + std::to_string(k + 1);
  }
  return project;
}

std::vector<cv::Mat> imagesOf(const FrameSet& set) {
  std::vector<cv::Mat> images;
  for (const FramePtr& frame : set.frames) {
    images.push_back(frame ? frame->image : cv::Mat());
  }
  return images;
}

/// What a run says that is given the frame sets themselves.
std::vector<TrajectorySample> trackedSets(const Project& project) {
  auto run = TrackingRun::create(project, 1).value();
  std::vector<TrajectorySample> samples;
  for (std::int64_t k = 0; k < kFedFrames; ++k) {
    run.beginFrame(test::DrawnRecording::frame(k));
    for (int i = 0; i < run.iterationsPerFrame(); ++i) {
      run.iterateTimed();
    }
    samples.push_back(run.samples().front());
  }
  return samples;
}

TEST(FrameFeed, GivesTheBitsOfARun) {
  for (const char* method : {"dewpoint", "barrera"}) {
    const Project project = namedProject(method);
    Trajectory tracked;
    tracked.samples = trackedSets(project);
    auto feed = FrameFeed::create(project, 2);
    ASSERT_TRUE(feed) << errorSentence(feed.error());
    EXPECT_TRUE(feed->samples().empty());
    for (int round = 0; round < 2; ++round) {
      Trajectory fed;
      for (std::int64_t k = 0; k < kFedFrames; ++k) {
        const auto set = test::DrawnRecording::frame(k);
        ASSERT_TRUE(feed->step(imagesOf(*set), seconds(set->time)));
        fed.samples.push_back(feed->samples().front());
      }
      EXPECT_TRUE(test::sameBits(fed, tracked)) << method << ", round " << round;
      EXPECT_EQ(feed->stepCount(), kFedFrames);
      feed->restart();
      EXPECT_EQ(feed->stepCount(), 0);
    }
  }
}

TEST(FrameFeed, KeepsTheImagesWithoutACopy) {
  auto feed = FrameFeed::create(namedProject("barrera"), 1).value();
  const auto images = imagesOf(*test::DrawnRecording::frame(0));
  ASSERT_TRUE(feed.step(images, 0.0));
  EXPECT_EQ(feed.run().frames()->frames.at(0)->image.data, images.at(0).data);
}

TEST(FrameFeed, RefusesImagesAndTimesThatDoNotFit) {
  auto feed = FrameFeed::create(namedProject("dewpoint"), 1).value();
  const auto images = imagesOf(*test::DrawnRecording::frame(0));
  const auto field = [&](const std::vector<cv::Mat>& given, double time) {
    const auto stepped = feed.step(given, time);
    return stepped ? std::string() : stepped.error().field;
  };
  EXPECT_EQ(field({images[0]}, 0.0), "images");
  EXPECT_EQ(field({cv::Mat(), cv::Mat()}, 0.0), "images");
  EXPECT_EQ(field({images[0], cv::Mat(images[1].size(), CV_8UC1)}, 0.0), "images");
  EXPECT_EQ(field({images[0], cv::Mat(3, 3, CV_8UC3)}, 0.0), "images");
  EXPECT_EQ(field(images, std::numeric_limits<double>::quiet_NaN()), "time");
  EXPECT_EQ(field(images, 1e12), "time");
  EXPECT_EQ(feed.stepCount(), 0);
  EXPECT_EQ(field({cv::Mat(), images[1]}, 1.0), "");
  EXPECT_EQ(field(images, 1.0), "time");
  EXPECT_EQ(field(images, 1.1), "");
  EXPECT_EQ(feed.stepCount(), 2);
}

TEST(FrameFeed, NeedsAProjectThatCanBeTracked) {
  Project project = namedProject("dewpoint");
  project.targets.clear();
  const auto without = FrameFeed::create(project, 1);
  ASSERT_FALSE(without);
  EXPECT_EQ(without.error().code, ErrorCode::MissingKey);
  EXPECT_EQ(without.error().field, "target");
  project.cameras.clear();
  EXPECT_FALSE(FrameFeed::create(project, 1));
}

} // namespace
} // namespace dewpoint::tests
