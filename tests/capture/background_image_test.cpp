// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/background_image.h"
#include "core/capture/frame_writer.h"
#include "tests/capture/temporary_folder.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include <fstream>

namespace dewpoint::tests {
namespace {

const ImageShape kCamera{"left", 0, 12, 8};

cv::Mat plain(int level) {
  return {8, 12, CV_8UC3, cv::Scalar(level, level + 1, level + 2)};
}

TEST(BackgroundImage, IsAPictureOrTheMedianOfMany) {
  const test::TemporaryFolder folder;
  cv::imwrite(folder / "one.png", plain(40));
  const auto one = readBackgroundImage(folder / "one.png", kCamera);
  ASSERT_TRUE(one) << errorSentence(one.error());
  EXPECT_EQ(cv::norm(*one, plain(40), cv::NORM_INF), 0.0);

  std::filesystem::create_directory(folder / "many");
  for (int k = 0; k < 5; ++k) {
    // Somebody walks through two of them.
    cv::imwrite(folder / ("many/" + std::to_string(k) + ".png"), plain(k < 2 ? 200 : 50));
  }
  const auto many = readBackgroundImage(folder / "many", kCamera);
  ASSERT_TRUE(many) << errorSentence(many.error());
  EXPECT_EQ(cv::norm(*many, plain(50), cv::NORM_INF), 0.0);

  auto writer = FrameWriter::createVideo(folder / "room.mkv", 30.0);
  ASSERT_TRUE(writer);
  for (int k = 0; k < 40; ++k) {
    ASSERT_TRUE(writer->write(plain(60)));
  }
  ASSERT_TRUE(writer->finish());
  const auto video = readBackgroundImage(folder / "room.mkv", kCamera);
  ASSERT_TRUE(video) << errorSentence(video.error());
  EXPECT_LE(cv::norm(*video, plain(60), cv::NORM_INF), 2.0);
}

TEST(BackgroundImage, IsTurnedAsTheCameraIs) {
  const test::TemporaryFolder folder;
  cv::imwrite(folder / "one.png", plain(40));
  const auto rotated = readBackgroundImage(folder / "one.png", {"left", 90, 8, 12});
  ASSERT_TRUE(rotated) << errorSentence(rotated.error());
  EXPECT_EQ(rotated->size(), cv::Size(8, 12));
}

TEST(BackgroundImage, WhatIsWrongNamesFileAndCamera) {
  const test::TemporaryFolder folder;
  cv::imwrite(folder / "small.png", plain(40));
  std::ofstream(folder / "broken.png") << "nothing";
  for (const auto& [name, camera] :
       {std::pair{"nowhere.png", kCamera}, std::pair{"broken.png", kCamera},
        std::pair{"small.png", ImageShape{"left", 0, 640, 480}}}) {
    const auto room = readBackgroundImage(folder / name, camera);
    ASSERT_FALSE(room) << name;
    EXPECT_NE(errorSentence(room.error()).find(name), std::string::npos)
        << errorSentence(room.error());
    EXPECT_NE(errorSentence(room.error()).find("left"), std::string::npos)
        << errorSentence(room.error());
  }
}

} // namespace
} // namespace dewpoint::tests
