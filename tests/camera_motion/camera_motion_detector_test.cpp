// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/angle.h"
#include "core/base/random.h"
#include "core/camera_motion/camera_motion_detector.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <cmath>

namespace dewpoint::tests {
namespace {

Camera lens() {
  Camera camera;
  camera.name = "left";
  camera.intrinsics = {640, 480, 550.0, 550.0, 319.5, 239.5};
  return camera;
}

/// A wall of smooth random structure, far larger than the image.
cv::Mat wall() {
  const RandomStream random(3, 0, 0, RandomPurpose::Noise);
  cv::Mat coarse(120, 160, CV_8UC3);
  for (int i = 0; i < coarse.rows * coarse.cols; ++i) {
    const auto color = random.uniform3(std::uint32_t(i));
    coarse.at<cv::Vec3b>(i / coarse.cols, i % coarse.cols) = {
        uchar(40 + 160 * color[0]), uchar(40 + 160 * color[1]), uchar(40 + 160 * color[2])};
  }
  cv::Mat result;
  cv::resize(coarse, result, {1280, 960}, 0, 0, cv::INTER_CUBIC);
  return result;
}

/// What the camera sees of a wall at infinity after a small turn: (1 + [turn]x) of its directions.
cv::Mat view(const cv::Mat& picture, const Eigen::Vector3d& turn, std::uint32_t frame) {
  const Camera camera = lens();
  const auto& in = camera.intrinsics;
  const Eigen::Matrix3d back =
      Eigen::AngleAxisd(-turn.norm(),
                        turn.norm() > 0.0 ? turn.normalized() : Eigen::Vector3d::UnitX())
          .toRotationMatrix();
  Eigen::Matrix3d k;
  k << in.focalX, 0, in.centerX, 0, in.focalY, in.centerY, 0, 0, 1;
  Eigen::Matrix3d wallFromPixel = k * back * k.inverse();
  cv::Matx33d map;
  for (int i = 0; i < 9; ++i) {
    map(i / 3, i % 3) = wallFromPixel(i / 3, i % 3);
  }
  const cv::Matx33d middle(1, 0, 320, 0, 1, 240, 0, 0, 1);
  cv::Mat image;
  cv::warpPerspective(picture, image, cv::Mat(middle * map), {in.width, in.height},
                      cv::INTER_CUBIC | cv::WARP_INVERSE_MAP);
  cv::Mat noise(image.size(), CV_16SC3);
  cv::RNG(frame + 1).fill(noise, cv::RNG::NORMAL, 0.0, 3.0);
  cv::Mat noisy;
  cv::add(image, noise, noisy, cv::noArray(), CV_8UC3);
  return noisy;
}

FrameSet frameSet(const cv::Mat& image, double time) {
  auto frame = std::make_shared<Frame>();
  frame->image = image;
  FrameSet set;
  set.index = std::int64_t(30.0 * time);
  set.time = timeStamp(time);
  set.frames = {frame};
  return set;
}

/// Seconds from the bump until it is reported; nothing when it never is. Ten seconds before it.
std::optional<double> delayOf(CameraMotionDetector& detector, const Eigen::Vector3d& turn) {
  const cv::Mat picture = wall();
  for (int i = 0; i < 150; ++i) {
    const double time = i / 10.0;
    const bool bumped = time >= 10.0;
    detector.watch(frameSet(
        view(picture, bumped ? turn : Eigen::Vector3d::Zero().eval(), std::uint32_t(i)), time));
    if (!detector.events().empty()) {
      return time - 10.0;
    }
  }
  return std::nullopt;
}

TEST(CameraMotionDetector, ReportsATenthOfADegreeWithinTwoSeconds) {
  const Eigen::Vector3d turns[] = {{0.1, 0, 0}, {0, -0.1, 0}, {0, 0, 0.1}, {0.06, 0.06, 0.05}};
  for (const Eigen::Vector3d& degrees : turns) {
    CameraMotionDetector detector({lens()});
    const auto delay = delayOf(detector, degrees * kDegree);
    ASSERT_TRUE(delay) << degrees.transpose();
    EXPECT_GE(*delay, 0.0) << "before the bump";
    EXPECT_LT(*delay, 2.0);
    EXPECT_TRUE(detector.camera(0).hasMoved);
    // Half of the median's values may be from before: what is said then is between.
    EXPECT_GT(detector.events()[0].rotation.turn.norm(), 0.05 * kDegree);
  }
}

TEST(CameraMotionDetector, MeasuresTheTurnWellAfterwards) {
  const cv::Mat picture = wall();
  const Eigen::Vector3d turn = Eigen::Vector3d(0.3, -0.2, 0.25) * kDegree;
  CameraMotionDetector detector({lens()});
  for (int i = 0; i < 60; ++i) {
    detector.watch(frameSet(
        view(picture, i < 20 ? Eigen::Vector3d::Zero().eval() : turn, std::uint32_t(i)), i / 10.0));
  }
  EXPECT_LT((detector.camera(0).rotation.turn - turn).norm(), 0.01 * kDegree);
  EXPECT_EQ(detector.events().size(), 1U);
}

TEST(CameraMotionDetector, FindsLargeBumpsToo) {
  CameraMotionDetector detector({lens()}); // 4 degrees are 38 px
  const auto delay = delayOf(detector, Eigen::Vector3d(0.0, 4.0, 0.0) * kDegree);
  ASSERT_TRUE(delay);
  EXPECT_LT(*delay, 2.0);
  EXPECT_NEAR(detector.events()[0].rotation.turn.y() / kDegree, 4.0, 0.05);
}

TEST(CameraMotionDetector, LightAndMovingThingsAreNoBump) {
  const cv::Mat picture = wall();
  CameraMotionDetector detector({lens()});
  for (int i = 0; i < 300; ++i) {
    cv::Mat image = view(picture, Eigen::Vector3d::Zero(), std::uint32_t(i));
    // The lamp is dimmed to half, and a textured thing as large as a third of the image walks by.
    image.convertTo(image, -1, 0.75 + 0.25 * std::cos(i / 30.0), 0.0);
    const int left = (7 * i) % 640;
    const cv::Rect place(left, 0, std::min(210, 640 - left), 480);
    picture(cv::Rect(600, 300, place.width, 480)).copyTo(image(place));
    detector.watch(frameSet(image, i / 10.0));
  }
  for (const CameraMotionEvent& event : detector.events()) {
    ADD_FAILURE() << "frame " << event.frame << ", " << event.rotation.turn.transpose() / kDegree
                  << " degrees, sigma " << event.rotation.sigma / kDegree << ", "
                  << event.rotation.usedShiftCount << " pieces";
  }
  EXPECT_TRUE(detector.camera(0).isAssessed);
  EXPECT_LT(detector.camera(0).rotation.turn.norm(), 0.01 * kDegree);
}

TEST(CameraMotionDetector, ACameraThatSeesNothingIsNotJudged) {
  CameraMotionDetector detector({lens()});
  const cv::Mat gray(480, 640, CV_8UC3, cv::Scalar::all(90));
  for (int i = 0; i < 30; ++i) {
    detector.watch(frameSet(gray, i / 10.0));
  }
  EXPECT_FALSE(detector.camera(0).isAssessed);
  EXPECT_TRUE(detector.events().empty());
}

TEST(CameraMotionDetector, ComesBackAndStartsAnewWhenAccepted) {
  const cv::Mat picture = wall();
  const Eigen::Vector3d turn = Eigen::Vector3d(0.0, 0.2, 0.0) * kDegree;
  CameraMotionDetector detector({lens()});
  std::uint32_t frame = 0;
  const auto stand = [&](const Eigen::Vector3d& as) {
    for (int i = 0; i < 30; ++i, ++frame) {
      detector.watch(frameSet(view(picture, as, frame), frame / 10.0));
    }
  };
  stand(Eigen::Vector3d::Zero());
  stand(turn);
  EXPECT_TRUE(detector.camera(0).hasMoved);
  stand(Eigen::Vector3d::Zero());
  EXPECT_FALSE(detector.camera(0).hasMoved);
  stand(turn);
  EXPECT_EQ(detector.events().size(), 2U);
  detector.acceptMovedCamera(0, lens());
  stand(turn);
  EXPECT_FALSE(detector.camera(0).hasMoved);
  EXPECT_LT(detector.camera(0).rotation.turn.norm(), 0.01 * kDegree);
}

} // namespace
} // namespace dewpoint::tests
