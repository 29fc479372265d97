// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings whose pictures were not taken evenly.
#include "core/capture/recording.h"
#include "tests/capture/temporary_folder.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include <filesystem>
#include <fstream>

namespace dewpoint::tests {
namespace {

using test::TemporaryFolder;

class TimedRecording : public testing::Test {
protected:
  /// A folder of gray pictures, each as bright as its number.
  RecordedCamera folder(const std::string& name, const std::vector<int>& numbers) {
    std::filesystem::create_directories(home_ / name);
    for (const int number : numbers) {
      const std::string file = home_ / name + "/" + std::to_string(1000 + number) + ".png";
      cv::imwrite(file, cv::Mat(4, 6, CV_8UC3, cv::Scalar::all(number)));
    }
    RecordedCamera camera;
    camera.name = name;
    camera.kind = RecordedCamera::Kind::Images;
    camera.path = home_ / name;
    return camera;
  }
  std::string table(const std::string& text) {
    std::ofstream(home_ / "times.csv") << text;
    return home_ / "times.csv";
  }
  /// The brightness of each camera's pictures, frame by frame; -1: none.
  static std::vector<std::vector<int>> seen(FrameSetSource& source) {
    std::vector<std::vector<int>> all;
    for (auto set = source.next(); set && *set; set = source.next()) {
      all.emplace_back();
      for (const FramePtr& frame : (*set)->frames) {
        all.back().push_back(frame ? frame->image.at<cv::Vec3b>(0, 0)[0] : -1);
      }
    }
    return all;
  }

  TemporaryFolder home_;
};

using Seen = std::vector<std::vector<int>>;

TEST_F(TimedRecording, MissingNumbersOfAFolderAreNoImage) {
  const auto source =
      openRecording({folder("left", {0, 1, 2, 3, 4}), folder("right", {7, 8, 11})}, 10);
  ASSERT_TRUE(source) << errorSentence(source.error());
  EXPECT_EQ(seen(**source), (Seen{{0, 7}, {1, 8}, {2, -1}, {3, -1}, {4, 11}}));
  const auto notices = (*source)->notices();
  ASSERT_EQ(notices.size(), 1U);
  EXPECT_EQ(notices[0].detail,
            "by the numbers in the file names, 2 images are missing, the first after 1008.png; "
            "the camera has no image in these frames");
  ASSERT_TRUE((*source)->seek(4));
  EXPECT_EQ(seen(**source), (Seen{{4, 11}}));
}

TEST_F(TimedRecording, PicturesArePairedByTheirTimes) {
  RecordedCamera left = folder("left", {0, 1, 2, 3});
  RecordedCamera right = folder("right", {0, 1});
  left.timesFile = right.timesFile =
      table("camera,time_ms\nleft,100\nleft,200\nleft,300\nleft,400\nright,190\nright,405\n");
  const auto source = openRecording({left, right}, 0);
  ASSERT_TRUE(source) << errorSentence(source.error());
  EXPECT_NEAR((*source)->framesPerSecond(), 10.0, 1e-9);
  EXPECT_EQ(seen(**source), (Seen{{1, 0}, {2, -1}, {3, 1}}));
  EXPECT_TRUE((*source)->notices().empty());
  ASSERT_TRUE((*source)->seek(2));
  const auto set = (*source)->next().value();
  EXPECT_EQ(set->frames[1]->captureTime, timeStamp(0.215));
  EXPECT_EQ(set->time, timeStamp(0.2));
}

TEST_F(TimedRecording, AWrongTableIsRefused) {
  RecordedCamera left = folder("left", {0, 1});
  RecordedCamera right = folder("right", {0, 1});
  left.timesFile = table("0\n1\n");
  const auto mixed = openRecording({left, right}, 0);
  ASSERT_FALSE(mixed);
  EXPECT_EQ(mixed.error().code, ErrorCode::MissingKey);
  EXPECT_EQ(mixed.error().field, "camera 'right'");
  left.timesFile = table("0\n1\n2\n");
  const auto longer = openRecording({left}, 0);
  ASSERT_FALSE(longer);
  EXPECT_EQ(longer.error().detail, "it has 3 times, but there are 2 images");
}

} // namespace
} // namespace dewpoint::tests
