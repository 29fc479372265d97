// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/background_images.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include <filesystem>
#include <string>

namespace dewpoint::tests {
namespace {

TEST(BackgroundImages, ASavedImageIsReadAsItWas) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "background_images";
  std::filesystem::remove_all(folder);
  cv::Mat image(50, 80, CV_8UC3);
  cv::randu(image, cv::Scalar::all(0), cv::Scalar::all(255));
  Project project;
  project.name = "desk";
  ProjectCamera& camera = project.cameras.emplace_back();
  camera.camera.name = "left";
  camera.camera.intrinsics = {80, 50, 100.0, 100.0, 39.5, 24.5};
  camera.rotateDegrees = 90;
  camera.isMirrored = true;
  camera.crop = {10, 2, 4, 6};
  const auto file = saveBackgroundImage(project, 0, image, folder);
  ASSERT_TRUE(file) << errorSentence(file.error());
  // As the camera sends it: 94 x 58 before it is cropped, lying on its side.
  EXPECT_EQ(cv::imread(file->string()).size(), cv::Size(58, 94));
  camera.backgroundImageFile = file->string();
  const auto read = loadBackgroundImages(project);
  ASSERT_TRUE(read) << errorSentence(read.error());
  ASSERT_EQ(read->size(), 1U);
  EXPECT_EQ(read->front().size(), image.size());
  EXPECT_EQ(cv::norm(read->front(), image, cv::NORM_INF), 0.0);
  std::filesystem::remove_all(folder);
}

} // namespace
} // namespace dewpoint::tests
