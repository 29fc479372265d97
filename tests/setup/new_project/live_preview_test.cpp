// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/new_project/live_preview.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

bool always() {
  return true;
}

TEST(LivePreview, ATestPatternSaysItsSizeAndRate) {
  const auto tried = captureLivePreview("test:ball?width=640&height=360&rate=20", &always);
  ASSERT_TRUE(tried) << errorSentence(tried.error());
  EXPECT_EQ(tried->size, cv::Size(640, 360));
  EXPECT_EQ(tried->image.size(), cv::Size(192, 108));
  EXPECT_EQ(tried->image.type(), CV_8UC3);
  EXPECT_NEAR(tried->framesPerSecond, 20.0, 4.0);
}

TEST(LivePreview, WhatCannotBeOpenedSaysWhy) {
  const auto missing = captureLivePreview("/dev/video97", &always);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::DeviceUnavailable);
  EXPECT_EQ(missing.error().file, "/dev/video97");
  EXPECT_FALSE(missing.error().detail.empty());
  const auto unknown = captureLivePreview("test:no-such-pattern", &always);
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::BadValue);
}

TEST(LivePreview, PasswordsAreNotShown) {
  const auto tried = captureLivePreview("rtsp://me:secret@127.0.0.1:1/door", &always);
  ASSERT_FALSE(tried);
  EXPECT_EQ(errorSentence(tried.error()).find("secret"), std::string::npos);
}

TEST(LivePreview, NobodyNeedsToWaitForTheEnd) {
  const auto tried = captureLivePreview("test:ball", [] { return false; });
  ASSERT_FALSE(tried);
  EXPECT_EQ(tried.error().code, ErrorCode::Canceled);
}

TEST(LivePreview, ImagesComeAtTheWantedPaceUntilNobodyWantsThem) {
  LiveCamera camera;
  camera.location = "test:ball?rate=30&width=320&height=240";
  int images = 0;
  const auto watched = previewLive(camera, 0.2, [&](const LivePreview& preview) {
    EXPECT_EQ(preview.size, cv::Size(320, 240));
    return ++images < 4;
  });
  EXPECT_TRUE(watched);
  EXPECT_EQ(images, 4);
  camera.location += "&frames=10"; // it ends by itself
  images = 0;
  EXPECT_TRUE(previewLive(camera, 0.0, [&](const LivePreview&) { return ++images > 0; }));
  EXPECT_LE(images, 10);
}

} // namespace
} // namespace dewpoint::tests
