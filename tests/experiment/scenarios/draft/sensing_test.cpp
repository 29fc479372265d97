// SPDX-License-Identifier: GPL-3.0-or-later
// What grades do to images, time stamps and calibration.
#include "core/experiment/scenarios/draft/grade_model.h"
#include "core/simulation/sensor/shutter.h"
#include "tests/experiment/scenarios/scenario_images.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>

namespace dewpoint::tests {
namespace {

using namespace dewpoint::experiment::scenarios;

RandomStream chancesOf(std::int64_t frame) {
  return {99, static_cast<std::uint32_t>(frame), 0, RandomPurpose::Start};
}

TEST(CameraTiming, IsRightUnlessSetOtherwise) {
  for (std::int64_t frame = 0; frame < 50; ++frame) {
    const auto delivery = deliveryOf({}, frame, chancesOf(frame));
    ASSERT_TRUE(delivery);
    EXPECT_EQ(delivery->shownFrame, frame);
    EXPECT_EQ(delivery->timeStampError, 0.0);
  }
  EXPECT_EQ(midExposureTime({}, 1.25), 1.25);
}

TEST(CameraTiming, DropsAndDoublesItsShares) {
  CameraTiming timing;
  timing.droppedFrameShare = 0.1;
  timing.repeatedFrameShare = 0.2;
  int dropped = 0;
  int doubled = 0;
  for (std::int64_t frame = 0; frame < 2000; ++frame) {
    const auto delivery = deliveryOf(timing, frame, chancesOf(frame));
    dropped += delivery ? 0 : 1;
    doubled += delivery && delivery->shownFrame == frame - 1 ? 1 : 0;
  }
  // Of 2000: 200 (standard deviation 13) and 0.2 of the rest, 360 (17).
  EXPECT_NEAR(dropped, 200, 55);
  EXPECT_NEAR(doubled, 360, 70);
}

TEST(CameraTiming, FreezesAtTheLastImageBefore) {
  CameraTiming timing;
  timing.freezeBegin = 10;
  timing.freezeEnd = 13;
  const auto shown = [&](std::int64_t frame) {
    return deliveryOf(timing, frame, chancesOf(frame))->shownFrame;
  };
  EXPECT_EQ(shown(9), 9);
  EXPECT_EQ(shown(10), 9);
  EXPECT_EQ(shown(12), 9);
  EXPECT_EQ(shown(13), 13);
}

TEST(CameraTiming, ExposesBeforeTheStamp) {
  CameraTiming timing;
  timing.delaySeconds = 0.012;
  timing.clockDrift = 0.001;
  EXPECT_NEAR(midExposureTime(timing, 5.0), 5.0 - 0.012 - 0.005, 1e-12);
}

TEST(CalibrationErrors, HaveTheStatedSizes) {
  const Camera truth = scenarioRun("S0-slow").trueRig[0];
  RandomDraws draws(5, "calibration test");
  EXPECT_EQ(withCalibrationError(truth, {}, draws), truth);
  const CalibrationError error{0.005, 0.002, 0.003, 0.01};
  constexpr int kDraws = 2000;
  double focal = 0.0;
  double position = 0.0;
  double rotation = 0.0;
  double radial = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const Camera camera = withCalibrationError(truth, error, draws);
    focal += std::pow(camera.intrinsics.focalX / truth.intrinsics.focalX - 1.0, 2);
    position += (camera.center() - truth.center()).squaredNorm();
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(camera.cameraFromWorld.linear() *
                                                 truth.cameraFromWorld.linear().transpose()));
    rotation += turn.angle() * turn.angle();
    radial += std::pow(camera.distortion[0] - truth.distortion[0], 2);
  }
  // Of 2000 draws the deviation is known to 1.6 %.
  EXPECT_NEAR(std::sqrt(focal / kDraws), 0.005, 0.0004);
  EXPECT_NEAR(std::sqrt(position / kDraws), std::sqrt(3.0) * 0.002, 0.0002);
  EXPECT_NEAR(std::sqrt(rotation / kDraws), 0.003, 0.00025);
  EXPECT_NEAR(std::sqrt(radial / kDraws), 0.01, 0.0008);
}

TEST(Grades, LampsLightTheTargetMoreThanFarWalls) {
  FaultContext context;
  context.cameraCount = 1;
  context.targetStart = {0.5, 0.5, 0.15};
  for (const Grade grade : {Grade::Room, Grade::Wild}) {
    RandomDraws draws(4, "lamp test");
    for (const auto& lamp :
         randomFaults(gradeModel(grade), context, draws).illumination.additionalLamps) {
      const float distance = (lamp.position - context.targetStart.cast<float>()).norm();
      EXPECT_FLOAT_EQ(lamp.falloffAt(distance), 1.0F);
      EXPECT_FLOAT_EQ(lamp.falloffAt(2.0F * distance), 0.25F);
    }
  }
}

/// How much the light of the rows of a camera's image swings in a grade, at most: amplitude of the
/// bands, of the mean light.
double strongestBands(Grade grade) {
  FaultContext context;
  context.cameraCount = 2;
  double most = 0.0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    RandomDraws draws(seed, "band test");
    for (const CameraFaults& camera : randomFaults(gradeModel(grade), context, draws).cameras) {
      const auto gains = simulation::rowGains(camera.sensor.flicker, camera.sensor.shutter, 240, 0);
      const auto [low, high] = std::ranges::minmax_element(gains);
      most = std::max(most, 0.5 * double{*high - *low});
    }
  }
  return most;
}

TEST(Grades, FlickerMakesBands) {
  // Exposures of 10 to 33 ms leave up to 0.217 of a swing of 0.35 (room) and 0.9 (wild).
  EXPECT_GT(strongestBands(Grade::Room), 0.03);
  EXPECT_LT(strongestBands(Grade::Room), 0.08);
  EXPECT_GT(strongestBands(Grade::Wild), strongestBands(Grade::Room));
  EXPECT_EQ(strongestBands(Grade::Ideal), 0.0);
}

TEST(Grades, IdealHasNothingWrong) {
  const ScenarioRun run = scenarioRun("S0-slow");
  EXPECT_EQ(run.rig, run.trueRig);
  EXPECT_EQ(largestStampError(run), 0.0);
}

TEST(Grades, RoomHasMuchWrongAndTheSameBitsAgain) {
  const ScenarioRun run = scenarioRun("S0-slow", 3, Grade::Room);
  const ScenarioRun same = scenarioRun("S0-slow", 3, Grade::Room);
  EXPECT_EQ(run.rig, same.rig);
  ASSERT_EQ(run.rig.size(), 2U);
  for (std::size_t camera = 0; camera < run.rig.size(); ++camera) {
    EXPECT_NE(run.rig[camera], run.trueRig[camera]);
    const double shift = (run.rig[camera].center() - run.trueRig[camera].center()).norm();
    EXPECT_LT(shift, 0.012) << "2 mm per axis: farther than 6 deviations never";
  }
  EXPECT_GT(largestStampError(run), 0.0);
  for (const std::int64_t frame : {0, 40}) {
    const FrameSetPtr one = run.frames(frame);
    const FrameSetPtr other = same.frames(frame);
    for (std::size_t camera = 0; camera < one->frames.size(); ++camera) {
      ASSERT_EQ(one->frames[camera] == nullptr, other->frames[camera] == nullptr);
      if (one->frames[camera] != nullptr) {
        EXPECT_EQ(cv::norm(one->frames[camera]->image, other->frames[camera]->image, cv::NORM_INF),
                  0.0);
      }
    }
  }
}

} // namespace
} // namespace dewpoint::tests
