// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/watch/camera_motion_watch.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <numbers>

namespace dewpoint::tests {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kRadius = 0.1; // meters

CameraRig threeCameras() {
  CameraRig rig;
  for (int k = 0; k < 3; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 3;
    Camera camera;
    camera.name = "camera " + std::to_string(k + 1);
    camera.intrinsics = {640, 480, 500.0, 500.0, 319.5, 239.5};
    camera.cameraFromWorld =
        lookAt({2.5 * std::cos(angle), 2.5 * std::sin(angle), 1.6}, {0.0, 0.0, 0.5});
    rig.push_back(camera);
  }
  return rig;
}

Target redBall() {
  Target target;
  target.name = "red";
  target.radius = kRadius;
  target.color = {340.0, 20.0, 0.5, 1.0, 0.1, 0.9};
  return target;
}

Eigen::Vector3d place(double time) {
  return {0.4 * std::cos(time), 0.4 * std::sin(0.7 * time), 0.5 + 0.3 * std::sin(1.3 * time)};
}

/// A red disc before a wall of dots.
cv::Mat picture(const Camera& camera, double time) {
  cv::Mat image(480, 640, CV_8UC3, cv::Scalar::all(100));
  const Projector projector(camera);
  for (int i = 0; i < 400; ++i) {      // dots far away
    const double angle = 2.399963 * i; // the golden angle: evenly around
    const auto at =
        projector.project({30.0 * std::cos(angle), 30.0 * std::sin(angle), -25.0 + 0.11 * i});
    if (at) {
      constexpr int kShift = 6;
      const auto fixed = [](double value) { return int(std::lround(value * (1 << kShift))); };
      cv::circle(image, {fixed(at->x()), fixed(at->y())}, fixed(9.0), cv::Scalar::all(40 + i % 180),
                 cv::FILLED, cv::LINE_AA, kShift);
    }
  }
  const auto disc = SphereProjector(camera).project(place(time), kRadius);
  constexpr int kShift = 6;
  const auto fixed = [](double value) { return int(std::lround(value * (1 << kShift))); };
  cv::circle(image, {fixed(disc->center.x()), fixed(disc->center.y())}, fixed(disc->radius),
             {30, 30, 220}, cv::FILLED, cv::LINE_AA, kShift);
  return image;
}

/// Twenty seconds in which the second camera is turned after ten. The tracker is right all along.
void run(CameraMotionWatch& watch, const Camera& bumped) {
  CameraRig rig = threeCameras();
  SphereEstimate estimate;
  estimate.isValid = true;
  estimate.radius = kRadius;
  for (int i = 0; i < 200; ++i) {
    const double time = i / 10.0;
    if (i == 100) {
      rig[1] = bumped;
    }
    FrameSet frames;
    frames.index = i;
    frames.time = timeStamp(time);
    for (const Camera& camera : rig) {
      auto frame = std::make_shared<Frame>();
      frame->image = picture(camera, time);
      frames.frames.push_back(frame);
    }
    estimate.mean = place(time);
    watch.watch(frames, {redBall()}, {estimate});
    if (i < 100) {
      ASSERT_TRUE(watch.reports().empty()) << time;
    }
  }
}

double angleBetween(const Camera& a, const Camera& b) {
  return Eigen::AngleAxisd(a.cameraFromWorld.linear() * b.cameraFromWorld.linear().transpose())
      .angle();
}

TEST(CameraMotionWatch, ReportsAndSolvesABumpedCamera) {
  Camera bumped = rotatedCamera(threeCameras()[1], Eigen::Vector3d(0.2, -0.3, 0.1) * kDegree);
  bumped.cameraFromWorld.translation().x() += 0.003;
  CameraMotionWatch watch(threeCameras());
  run(watch, bumped);
  ASSERT_EQ(watch.reports().size(), 1U);
  const CameraMotionReport& report = watch.reports()[0];
  EXPECT_EQ(report.event.camera, 1U);
  ASSERT_TRUE(report.targetDistancePx);
  EXPECT_NEAR(*report.targetDistancePx, 3.1, 1.0);
  EXPECT_LT(seconds(report.event.time), 12.0);
  ASSERT_TRUE(report.newPose);
  EXPECT_LT(angleBetween(report.newPose->camera, bumped), 0.05 * kDegree);
  EXPECT_LT(report.newPose->medianResidualPxAfter, 0.3);
  EXPECT_GT(report.newPose->medianResidualPxBefore, 2.0); // 0.36 degrees at 500 px are 3.1 px
  ASSERT_EQ(watch.notices().size(), 1U);
  EXPECT_EQ(watch.notices()[0].field, "camera 2");
  EXPECT_NE(watch.notices()[0].detail.find("degrees"), std::string::npos);
}

TEST(CameraMotionWatch, ACameraThatIsCalibratedAgainIsNotReportedAnyMore) {
  CameraRig rig = threeCameras();
  const Camera bumped = rotatedCamera(rig[1], Eigen::Vector3d(0.2, -0.3, 0.1) * kDegree);
  CameraMotionWatch watch(rig);
  run(watch, bumped);
  ASSERT_EQ(watch.reports().size(), 1U);
  ASSERT_TRUE(watch.reports()[0].newPose);
  rig[1] = watch.reports()[0].newPose->camera;
  watch.setCameras(rig);
  EXPECT_TRUE(watch.reports().empty());
}

TEST(CameraMotionWatch, WhatWasSolvedIsNotReportedWhenTheRecordingPlaysAgain) {
  const Camera bumped = rotatedCamera(threeCameras()[1], Eigen::Vector3d(0.2, -0.3, 0.1) * kDegree);
  CameraMotionWatch watch(threeCameras());
  run(watch, bumped);
  ASSERT_EQ(watch.reports().size(), 1U);
  CameraRig solved = threeCameras();
  solved[1] = bumped;
  watch.setCameras(solved);
  watch.restart();
  run(watch, bumped);
  EXPECT_TRUE(watch.reports().empty());
  // Taken back, it is news again.
  watch.setCameras(threeCameras());
  watch.restart();
  run(watch, bumped);
  EXPECT_EQ(watch.reports().size(), 1U);
}

TEST(CameraMotionWatch, ForgetsWhenTheRunBeginsAnew) {
  CameraMotionWatch watch(threeCameras());
  run(watch, rotatedCamera(threeCameras()[1], Eigen::Vector3d(0.2, -0.3, 0.1) * kDegree));
  watch.restart();
  EXPECT_TRUE(watch.reports().empty());
  EXPECT_TRUE(watch.notices().empty());
}

/// A board of gray squares that fills most of the image, held and slowly moved by a hand.
cv::Mat boardBefore(const Camera& camera, double time) {
  cv::Mat image = picture(camera, time);
  const int left = 60 + int(std::lround(15.0 * std::sin(0.5 * time)));
  const int top = 40 + int(std::lround(12.0 * std::sin(0.4 * time)));
  for (int i = 0; i < 13 * 10; ++i) {
    const cv::Rect square(left + 40 * (i % 13), top + 40 * (i / 13), 40, 40);
    cv::rectangle(image, square, cv::Scalar::all(20 + 37 * i % 211), cv::FILLED);
  }
  return image;
}

template <class Picture>
void show(CameraMotionWatch& watch, const CameraRig& rig, double from, double to,
          const Picture& pictureOf) {
  for (int i = int(std::lround(10.0 * from)); i < int(std::lround(10.0 * to)); ++i) {
    FrameSet frames;
    frames.index = i;
    frames.time = timeStamp(i / 10.0);
    for (const Camera& camera : rig) {
      auto frame = std::make_shared<Frame>();
      frame->image = pictureOf(camera, i / 10.0);
      frames.frames.push_back(frame);
    }
    watch.watch(frames, {}, {});
  }
}

TEST(CameraMotionWatch, ABoardWavedBeforeTheCamerasIsNoBumpWhileItRests) {
  const CameraRig rig = threeCameras();
  CameraMotionWatch awake(rig);
  show(awake, rig, 0.0, 6.0, boardBefore);
  EXPECT_FALSE(awake.reports().empty()) << "if images alone tell, nothing needs to rest";

  CameraMotionWatch watch(rig);
  watch.setPaused(true);
  show(watch, rig, 0.0, 6.0, boardBefore);
  watch.setPaused(false);
  show(watch, rig, 6.0, 8.0, boardBefore); // it is still in the hand
  show(watch, rig, 8.0, 12.0, picture);
  EXPECT_TRUE(watch.reports().empty());
  CameraRig bumped = rig;
  bumped[1] = rotatedCamera(rig[1], Eigen::Vector3d(0.2, -0.3, 0.1) * kDegree);
  show(watch, bumped, 12.0, 18.0, picture);
  ASSERT_EQ(watch.reports().size(), 1U);
  EXPECT_EQ(watch.reports()[0].event.camera, 1U);
}

TEST(CameraMotionWatch, WhatWasReportedBeforeStaysWhileItRests) {
  CameraRig rig = threeCameras();
  CameraMotionWatch watch(rig);
  show(watch, rig, 0.0, 3.0, picture);
  CameraRig bumped = rig;
  bumped[1] = rotatedCamera(rig[1], Eigen::Vector3d(0.2, -0.3, 0.1) * kDegree);
  show(watch, bumped, 3.0, 9.0, picture);
  ASSERT_EQ(watch.reports().size(), 1U);
  watch.setPaused(true);
  show(watch, bumped, 9.0, 12.0, boardBefore);
  watch.setPaused(false);
  show(watch, bumped, 12.0, 15.0, picture);
  ASSERT_EQ(watch.reports().size(), 1U);
  EXPECT_FALSE(watch.reports()[0].isBackInPose);
}

} // namespace
} // namespace dewpoint::tests
