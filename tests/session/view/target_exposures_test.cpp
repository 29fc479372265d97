// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/sphere_image.h"
#include "core/session/view/target_exposures.h"
#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <memory>

namespace dewpoint::tests {
namespace {

using test::kBall;
using test::kBallRadius;

const cv::Scalar kOrange(30, 120, 200);
const cv::Scalar kClipped(10, 140, 255);

/// A gray image of a camera, with the ball in it.
cv::Mat imageOfBall(const Camera& camera, const cv::Scalar& color) {
  cv::Mat image(camera.intrinsics.height, camera.intrinsics.width, CV_8UC3, cv::Scalar::all(110));
  const auto circle = SphereProjector(camera).project(kBall, kBallRadius);
  cv::circle(image, cv::Point(cvRound(circle->center.x()), cvRound(circle->center.y())),
             cvCeil(circle->radius), color, cv::FILLED);
  return image;
}

/// Both cameras see the ball; the right one is overexposed.
struct ExposedBall {
  ExposedBall() {
    const CameraRig rig = test::twoCameras();
    snapshot.rig = std::make_shared<const CameraRig>(rig);
    setImages(imageOfBall(rig[0], kOrange), imageOfBall(rig[1], kClipped));
    TargetSnapshot& target = snapshot.targets.emplace_back();
    target.target.name = "ball";
    SphereEstimate estimate;
    estimate.mean = kBall;
    estimate.radius = kBallRadius;
    estimate.particleCount = 100;
    estimate.isValid = true;
    target.estimate = estimate;
    target.cameraReports.resize(2);
  }
  void setImages(const cv::Mat& left, const cv::Mat& right) {
    auto set = std::make_shared<FrameSet>();
    for (const cv::Mat& image : {left, right}) {
      auto frame = std::make_shared<Frame>();
      frame->image = image;
      set->frames.push_back(std::move(frame));
    }
    snapshot.frames = std::move(set);
  }
  void loseTarget() { std::get<SphereEstimate>(snapshot.targets[0].estimate).isValid = false; }

  TrackSnapshot snapshot;
};

TEST(TargetExposures, ATrackedTargetIsMeasuredInsideItsOutline) {
  const ExposedBall ball;
  const auto left = exposuresInView(ball.snapshot, 0);
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left[0].name, "ball");
  EXPECT_TRUE(left[0].isTracked);
  EXPECT_EQ(left[0].exposure.fault(), ExposureFault::None);
  EXPECT_EQ(left[0].exposure.histogram[25],
            left[0].exposure.pixelCount); // nothing of the gray wall
  const auto right = exposuresInView(ball.snapshot, 1);
  ASSERT_EQ(right.size(), 1U);
  EXPECT_DOUBLE_EQ(right[0].exposure.clippedShare(), 1.0);
  EXPECT_EQ(right[0].exposure.fault(), ExposureFault::Overexposed);
}

TEST(TargetExposures, ACameraThatDoesNotConfirmTheTargetIsNotMeasured) {
  ExposedBall ball;
  ball.snapshot.targets[0].cameraReports[1].status = CameraStatus::Hidden;
  EXPECT_TRUE(exposuresInView(ball.snapshot, 1).empty());
  EXPECT_EQ(exposuresInView(ball.snapshot, 0).size(), 1U);
}

TEST(TargetExposures, BeforeTrackingTheRegionOfTheSampleIsMeasured) {
  ExposedBall ball;
  ball.loseTarget();
  EXPECT_TRUE(exposuresInView(ball.snapshot, 0).empty());
  const Camera& camera = (*ball.snapshot.rig)[0];
  const auto circle = SphereProjector(camera).project(kBall, kBallRadius);
  ColorSample sample;
  sample.camera = 0;
  sample.x = circle->center.x();
  sample.y = circle->center.y();
  sample.colors = {{30, 120, 200}};
  ball.snapshot.targets[0].target.samples = {sample};
  const auto measured = exposuresInView(ball.snapshot, 0);
  ASSERT_EQ(measured.size(), 1U);
  EXPECT_FALSE(measured[0].isTracked);
  EXPECT_EQ(measured[0].exposure.fault(), ExposureFault::None);
  EXPECT_TRUE(exposuresInView(ball.snapshot, 1).empty()); // it has no sample
  const cv::Mat blue(camera.intrinsics.height, camera.intrinsics.width, CV_8UC3,
                     cv::Scalar(255, 60, 20));
  ball.setImages(blue, blue);
  EXPECT_TRUE(exposuresInView(ball.snapshot, 0).empty()); // the object is gone
}

TEST(TargetExposures, WithoutAnImageThereIsNothing) {
  ExposedBall ball;
  EXPECT_TRUE(exposuresInView(ball.snapshot, -1).empty());
  EXPECT_TRUE(exposuresInView(ball.snapshot, 2).empty());
  ball.snapshot.frames = nullptr;
  EXPECT_TRUE(exposuresInView(ball.snapshot, 0).empty());
}

TEST(TargetExposures, TheWorstOfSeveralIsFound) {
  EXPECT_EQ(worstExposure({}), nullptr);
  std::vector<ExposureInView> views(3);
  views[0].exposure.pixelCount = 100;
  views[0].exposure.darkCount = 80;
  views[1].exposure.pixelCount = 100;
  views[1].exposure.clippedCount = 25;
  views[2].exposure.pixelCount = 100;
  views[2].exposure.clippedCount = 10;
  EXPECT_EQ(worstExposure(views), &views[1]);
  views.erase(views.begin() + 1);
  EXPECT_EQ(worstExposure(views), &views[0]);
}

} // namespace
} // namespace dewpoint::tests
