// SPDX-License-Identifier: GPL-3.0-or-later
// Why a target is not held, with scenes drawn for each reason.
#include "core/geometry/sphere_image.h"
#include "tests/tracking/drawn_run.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

using drawn::Ball;
using drawn::DrawnRun;

const Ball kTarget{drawn::kMiddle};

/// A gray ball on the way from a camera to the target that hides it.
Ball cover(const Camera& camera, double radius = 0.05) {
  return {camera.center() + 0.5 * (kTarget.center - camera.center()), radius, {140, 140, 140}};
}

std::vector<CameraStatus> statuses(DrawnRun& run) {
  std::vector<CameraStatus> all;
  for (const CameraReport& report : run.tracker().cameraReports(0)) {
    all.push_back(report.status);
  }
  return all;
}

using All = std::vector<CameraStatus>;

class CameraReportTest : public ::testing::Test {
protected:
  CameraReportTest() : run_(drawn::rigAround(2), {drawn::redBall()}) {
    for (int frame = 0; frame < 20; ++frame) {
      run_.show({kTarget});
    }
    EXPECT_TRUE(run_.estimate().isValid);
  }
  DrawnRun run_;
};

TEST_F(CameraReportTest, NoTroubleWhileItIsSeen) {
  EXPECT_EQ(statuses(run_), (All{CameraStatus::None, CameraStatus::None}));
  EXPECT_EQ(describeUnconfirmedCameras(run_.tracker().cameraReports(0), {"left", "right"}), "");
}

TEST_F(CameraReportTest, HiddenFromOneCamera) {
  run_.show({kTarget, cover(run_.rig()[1])});
  EXPECT_EQ(statuses(run_), (All{CameraStatus::None, CameraStatus::Hidden}));
  EXPECT_EQ(describeUnconfirmedCameras(run_.tracker().cameraReports(0), {"left", "right"}),
            "camera right: hidden");
}

TEST_F(CameraReportTest, NoImageAndTooDark) {
  auto set = drawn::framesOf(run_.rig(), {kTarget}, run_.index(), {0});
  auto black = std::make_shared<Frame>(*set->frames[1]);
  black->image = cv::Mat(240, 320, CV_8UC3, cv::Scalar(9, 4, 7)); // all below 24
  set->frames[1] = black;
  run_.showSet(set);
  EXPECT_EQ(statuses(run_), (All{CameraStatus::NoImage, CameraStatus::Dark}));
}

TEST_F(CameraReportTest, BesideADistractor) {
  // Seen from both cameras the other ball is 8 cm away; it is watched before the target goes.
  const Ball other{kTarget.center + Eigen::Vector3d(0.0, 0.0, 0.085)};
  for (int frame = 0; frame < 20; ++frame) {
    run_.show({kTarget, other});
  }
  run_.show({other});
  run_.show({other});
  const auto reports = run_.tracker().cameraReports(0);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(reports[k].status, CameraStatus::Distractor);
    const SphereProjector projector(run_.rig()[k]);
    const auto a = projector.project(kTarget.center, kTarget.radius).value();
    const auto b = projector.project(other.center, other.radius).value();
    const double gap = (a.center - b.center).norm() - a.radius - b.radius;
    EXPECT_NEAR(reports[k].outlineDistancePx, gap, 2.0);
  }
}

TEST_F(CameraReportTest, GoneWithoutATraceAndNoColorAtAll) {
  for (int frame = 0; frame < 100; ++frame) {
    run_.show({});
  }
  EXPECT_EQ(statuses(run_), (All{CameraStatus::NoColor, CameraStatus::NoColor}));
}

TEST_F(CameraReportTest, OutOfView) {
  // To the right out of the first camera's image; the second looks along the way.
  Eigen::Vector3d place = kTarget.center;
  const Eigen::Vector3d right = run_.rig()[0].cameraFromWorld.linear().row(0).transpose();
  for (int frame = 0; frame < 45; ++frame) {
    place += 0.02 * right;
    run_.show({{place}});
  }
  EXPECT_EQ(run_.tracker().cameraReports(0)[0].status, CameraStatus::OutOfView);
}

TEST(BarreraReports, SayWhereTheColorIs) {
  const CameraRig rig = drawn::rigAround(2);
  auto tracker =
      makeTracker("barrera", drawn::parametersOf("barrera", {{"start_x", 0.5}, {"start_y", 0.5}}),
                  rig, {drawn::redBall()});
  ASSERT_TRUE(tracker);
  (*tracker)->restart(1);
  ThreadTeam team;
  const Ball far{drawn::kMiddle + Eigen::Vector3d(0.2, -0.2, 0.0)};
  for (int frame = 0; frame < 10; ++frame) {
    (*tracker)->beginFrame(drawn::framesOf(rig, {kTarget}, frame));
    (*tracker)->iterate(team);
  }
  (*tracker)->beginFrame(drawn::framesOf(rig, {far}, 10));
  (*tracker)->iterate(team);
  for (std::size_t k = 0; k < 2; ++k) {
    const CameraReport report = capability<CameraReporting>(**tracker)->cameraReports(0)[k];
    EXPECT_EQ(report.status, CameraStatus::Elsewhere);
    const Projector projector(rig[k]);
    const auto middle = projector.project(sphereOf(**tracker).mean).value();
    const auto ball = SphereProjector(rig[k]).project(far.center, far.radius).value();
    EXPECT_NEAR(report.outlineDistancePx, (middle - ball.center).norm() - ball.radius, 1.5);
  }
  (*tracker)->beginFrame(drawn::framesOf(rig, {}, 11));
  (*tracker)->iterate(team);
  EXPECT_EQ(capability<CameraReporting>(**tracker)->cameraReports(0)[1].status,
            CameraStatus::NoColor);
}

TEST(ReasonSentence, NamesCamerasAndRounds) {
  EXPECT_EQ(describeUnconfirmedCameras(
                {{CameraStatus::Distractor, 3.4}, {CameraStatus::Hidden, 0.0}}, {"a"}),
            "camera a: 3 px away from a distractor; camera 2: hidden");
  EXPECT_EQ(describeUnconfirmedCameras({}, {}), "");
}

TEST(DistanceToNearest, IsThatOfTheNearestPixel) {
  cv::Mat mask = cv::Mat::zeros(20, 30, CV_8UC1);
  EXPECT_FALSE(distanceToNearestMaskPixel(mask, {3.0, 4.0}));
  mask.at<std::uint8_t>(10, 12) = 255;
  mask.at<std::uint8_t>(4, 8) = 255;
  EXPECT_DOUBLE_EQ(distanceToNearestMaskPixel(mask, {5.0, 8.0}).value(), 5.0); // 3, 4, 5
}

} // namespace
} // namespace dewpoint::tests
