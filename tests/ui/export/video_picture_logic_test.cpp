// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/snapshot/snapshot.h"
#include "ui/export/video_picture.h"
#include "ui/export/video_scene.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

/// Views of cameras with these aspects.
std::vector<VideoView> camerasWith(std::initializer_list<double> aspects) {
  std::vector<VideoView> views;
  for (const double aspect : aspects) {
    views.push_back({.camera = static_cast<int>(views.size()),
                     .title = QStringLiteral("camera"),
                     .options = {},
                     .aspect = aspect});
  }
  return views;
}

/// A frame of plain images, 64 x 48, each camera brighter than the one before.
TrackSnapshotPtr plainFrame(int cameras) {
  auto frames = std::make_shared<FrameSet>();
  for (int k = 0; k < cameras; ++k) {
    const cv::Mat image(48, 64, CV_8UC3, cv::Scalar::all(60 + 60 * k));
    frames->frames.push_back(std::make_shared<const Frame>(Frame{12, timeStamp(0.4), image}));
  }
  frames->index = 12;
  frames->time = timeStamp(0.4);
  auto snapshot = std::make_shared<TrackSnapshot>();
  snapshot->frames = frames;
  snapshot->frame = 12;
  return snapshot;
}

VideoLayout plainLook(int cameras, const QSize& size) {
  VideoLayout look;
  look.views = cameras == 1 ? camerasWith({4.0 / 3.0}) : camerasWith({4.0 / 3.0, 4.0 / 3.0});
  look.size = size;
  look.showsTitles = false;
  look.showsStamp = false;
  return look;
}

TEST(VideoPicture, AreasCoverTheImageWithoutOverlap) {
  for (std::size_t count = 1; count <= 7; ++count) {
    VideoLayout look;
    look.size = {1280, 720};
    for (std::size_t k = 0; k < count; ++k) {
      look.views.push_back(camerasWith({4.0 / 3.0}).front());
    }
    const auto areas = videoViewAreas(look);
    ASSERT_EQ(areas.size(), count);
    QRegion covered;
    int pixels = 0;
    for (const QRect& area : areas) {
      EXPECT_TRUE(QRect(QPoint(), look.size).contains(area)) << count;
      EXPECT_FALSE(covered.intersects(area)) << count;
      covered += area;
      pixels += area.width() * area.height();
    }
    if (count == 1 || count == 2) {
      EXPECT_EQ(pixels, 1280 * 720);
    }
  }
}

TEST(VideoPicture, TheSizeOfTheCameraImagesIsEvenAndLimited) {
  const auto sizeOf = [](std::vector<VideoView> views, int height) {
    for (VideoView& view : views) {
      view.height = height;
    }
    return naturalVideoSize(views);
  };
  EXPECT_EQ(sizeOf(camerasWith({4.0 / 3.0}), 480), QSize(640, 480));
  EXPECT_EQ(sizeOf(camerasWith({4.0 / 3.0, 4.0 / 3.0}), 480), QSize(1280, 480));
  EXPECT_EQ(sizeOf(camerasWith({1.0}), 241).height() % 2, 0);
  const QSize large = sizeOf(camerasWith({16.0 / 9.0, 16.0 / 9.0}), 4000);
  EXPECT_LE(large.width(), 3840);
  EXPECT_LE(large.height(), 2160);
  EXPECT_EQ(large.width() % 2, 0);
}

TEST(VideoPicture, ShowsEachCameraInItsArea) {
  const VideoLayout look = plainLook(2, {256, 96});
  const QImage picture = videoPicture(look, plainFrame(2), {});
  ASSERT_EQ(picture.size(), look.size);
  const auto areas = videoViewAreas(look);
  EXPECT_EQ(qGreen(picture.pixel(areas[0].center())), 60);
  EXPECT_EQ(qGreen(picture.pixel(areas[1].center())), 120);
}

TEST(VideoPicture, EnlargesASceneThatWasDrawnSmaller) {
  VideoLayout look = plainLook(1, {128, 96});
  look.views.front().camera.reset();
  QImage scene(16, 12, QImage::Format_RGB32);
  scene.fill(QColor(10, 200, 30));
  const QImage picture = videoPicture(look, plainFrame(1), scene);
  EXPECT_EQ(qGreen(picture.pixel(3, 3)), 200);
  EXPECT_EQ(qGreen(picture.pixel(124, 92)), 200);
}

TEST(VideoPicture, LabelsAreOptional) {
  VideoLayout look = plainLook(1, {640, 480});
  const QImage plain = videoPicture(look, plainFrame(1), {});
  look.showsStamp = true;
  const QImage stamped = videoPicture(look, plainFrame(1), {});
  const QRect top(0, 0, 640, 240);
  EXPECT_NE(plain, stamped);
  EXPECT_EQ(plain.copy(top), stamped.copy(top));
  look.showsTitles = true;
  EXPECT_NE(videoPicture(look, plainFrame(1), {}).copy(top), plain.copy(top));
}

TEST(VideoPicture, TheStampNamesRecordingFrameAndTime) {
  VideoLayout look;
  look.recordingName = QStringLiteral("take-003");
  // Frame 12 counted from 0; the window counts from 1.
  EXPECT_EQ(videoStampText(look, plainFrame(1)), QStringLiteral("take-003 · Frame 13 · 0.400 s"));
  look.recordingName.clear();
  EXPECT_EQ(videoStampText(look, plainFrame(1)), QStringLiteral("Frame 13 · 0.400 s"));
}

TEST(VideoPicture, SaysThatAnImageIsMissing) {
  const VideoLayout look = plainLook(2, {640, 240});
  const QImage picture = videoPicture(look, plainFrame(1), {}); // of two cameras
  const QRect area = videoViewAreas(look)[1];
  const QImage blank = [&] {
    QImage ground(area.size(), QImage::Format_RGB32);
    ground.fill(imageBackgroundColor(look.palette));
    return ground;
  }();
  EXPECT_NE(picture.copy(area), blank); // a text stands there
}

// 1 ms + 1 ms per 100,000 pixels: 10.2 ms for 1280 x 720.
TEST(VideoScene, IsDrawnAsLargeAsTheTimeAllows) {
  const QSize wanted(1280, 720);
  const auto ms = [](double pixels) { return 1.0 + 1e-5 * pixels; };
  const auto sizeFor = [&](double most) {
    return largestSizeWithinTime(wanted, 5e3, ms(5e3), 8e4, ms(8e4), most);
  };
  EXPECT_EQ(sizeFor(40.0), wanted);
  const QSize smaller = sizeFor(5.0);
  EXPECT_NEAR(ms(smaller.width() * smaller.height()), 5.0, 0.1);
  EXPECT_NEAR(static_cast<double>(smaller.width()) / smaller.height(), 16.0 / 9.0, 0.02);
  EXPECT_EQ(sizeFor(0.5), QSize(320, 180)); // never smaller than a quarter
  // A measurement that is no slower for more pixels is due to something else.
  EXPECT_EQ(largestSizeWithinTime(wanted, 5e3, 3.0, 8e4, 2.0, 40.0), wanted);
}

} // namespace
} // namespace dewpoint::tests
