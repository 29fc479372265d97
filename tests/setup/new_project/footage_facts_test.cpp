// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/frame_writer.h"
#include "core/setup/new_project/footage_facts.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include <filesystem>
#include <fstream>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;

class FootageFactsTest : public testing::Test {
protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / "footage-facts" /
              testing::UnitTest::GetInstance()->current_test_info()->name();
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  std::string video(const std::string& name, int frames, double rate) const {
    const std::string file = (folder_ / name).string();
    auto writer = FrameWriter::createVideo(file, rate);
    for (int k = 0; k < frames; ++k) {
      EXPECT_TRUE(writer->write(cv::Mat(240, 320, CV_8UC3, cv::Scalar(20, 120, 220))));
    }
    EXPECT_TRUE(writer->finish());
    return file;
  }

  fs::path folder_;
};

TEST_F(FootageFactsTest, OfAVideoAreSizeRateLengthAndASmallPicture) {
  const auto facts = readFootageFacts(video("left.mkv", 7, 25.0));
  ASSERT_TRUE(facts);
  ASSERT_TRUE(*facts);
  EXPECT_EQ((*facts)->width, 320);
  EXPECT_EQ((*facts)->height, 240);
  EXPECT_NEAR((*facts)->framesPerSecond, 25.0, 0.1);
  EXPECT_EQ((*facts)->frameCount, 7);
  EXPECT_LT((*facts)->preview.cols, 320);
  EXPECT_EQ((*facts)->preview.cols * 240, (*facts)->preview.rows * 320);
  EXPECT_EQ((*facts)->preview.type(), CV_8UC3);
}

TEST_F(FootageFactsTest, AFolderOfImagesHasNoRate) {
  for (const char* name : {"0.png", "1.png", "2.png"}) {
    cv::imwrite((folder_ / name).string(), cv::Mat(48, 64, CV_8UC1, cv::Scalar(9)));
  }
  const auto facts = readFootageFacts(folder_.string());
  ASSERT_TRUE(facts);
  ASSERT_TRUE(*facts);
  EXPECT_EQ((*facts)->frameCount, 3);
  EXPECT_EQ((*facts)->framesPerSecond, 0.0);
  EXPECT_EQ((*facts)->preview.size(), cv::Size(64, 48)); // small as it is
}

TEST_F(FootageFactsTest, WhatIsLiveIsNotTried) {
  for (const char* location : {"0", "/dev/video7", "rtsp://camera.example/1", "/dev/null"}) {
    const auto facts = readFootageFacts(location);
    ASSERT_TRUE(facts) << location;
    EXPECT_FALSE(*facts) << location;
  }
}

TEST_F(FootageFactsTest, WhatCannotBeReadSaysWhy) {
  const auto missing = readFootageFacts((folder_ / "nowhere.mkv").string());
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::FileMissing);
  std::ofstream(folder_ / "text.mp4") << "no video";
  const auto unreadable = readFootageFacts((folder_ / "text.mp4").string());
  ASSERT_FALSE(unreadable);
  EXPECT_EQ(unreadable.error().code, ErrorCode::FileUnreadable);
  EXPECT_FALSE(readFootageFacts(folder_.string())); // a folder without images
}

FootageFacts recording(int width, double rate, std::int64_t frames) {
  FootageFacts facts;
  facts.width = width;
  facts.height = 240;
  facts.framesPerSecond = rate;
  facts.frameCount = frames;
  return facts;
}

TEST(FootageDifferences, AreThoseThatMatter) {
  EXPECT_EQ(footageDifferences({}), FootageDifferences());
  const FootageFacts one = recording(320, 30.0, 378);
  EXPECT_EQ(footageDifferences({one}), FootageDifferences());
  EXPECT_EQ(footageDifferences({one, recording(320, 29.97, 378)}), FootageDifferences());
  EXPECT_EQ(footageDifferences({one, recording(320, 0.0, 378)}), FootageDifferences());
  const auto shorter = footageDifferences({one, recording(320, 30.0, 120)});
  EXPECT_EQ(shorter.shortestFrameCount, 120);
  EXPECT_FALSE(shorter.imageSizesDiffer || shorter.frameRatesDiffer);
  const auto other = footageDifferences({recording(320, 0.0, 9), recording(640, 25.0, 9), one});
  EXPECT_EQ(other.shortestFrameCount, 9);
  EXPECT_TRUE(other.imageSizesDiffer);
  EXPECT_TRUE(other.frameRatesDiffer);
}

} // namespace
} // namespace dewpoint::tests
