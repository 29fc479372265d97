// SPDX-License-Identifier: GPL-3.0-or-later
// What grades and the scenarios S14, S15, S16 and S20 do to images, time stamps and calibration.
#include "core/base/time.h"
#include "core/color/match_image.h"
#include "core/experiment/baselines/baseline_blobs.h"
#include "core/experiment/scenarios/draft/grade_model.h"
#include "core/simulation/sensor/shutter.h"
#include "tests/experiment/scenarios/scenario_images.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::tests {
namespace {

using namespace dewpoint::experiment::scenarios;

RandomStream chancesOf(std::int64_t frame) {
  return {99, static_cast<std::uint32_t>(frame), 0, RandomPurpose::Start};
}

TEST(CameraTiming, IsRightUnlessSetOtherwise) {
  for (std::int64_t frame = 0; frame < 50; ++frame) {
    const auto delivery = delivered({}, frame, chancesOf(frame));
    ASSERT_TRUE(delivery);
    EXPECT_EQ(delivery->shown, frame);
    EXPECT_EQ(delivery->stampError, 0.0);
  }
  EXPECT_EQ(exposureTime({}, 1.25), 1.25);
}

TEST(CameraTiming, DropsAndDoublesItsShares) {
  CameraTiming timing;
  timing.dropShare = 0.1;
  timing.doubleShare = 0.2;
  int dropped = 0;
  int doubled = 0;
  for (std::int64_t frame = 0; frame < 2000; ++frame) {
    const auto delivery = delivered(timing, frame, chancesOf(frame));
    dropped += delivery ? 0 : 1;
    doubled += delivery && delivery->shown == frame - 1 ? 1 : 0;
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
    return delivered(timing, frame, chancesOf(frame))->shown;
  };
  EXPECT_EQ(shown(9), 9);
  EXPECT_EQ(shown(10), 9);
  EXPECT_EQ(shown(12), 9);
  EXPECT_EQ(shown(13), 13);
}

TEST(CameraTiming, ExposesBeforeTheStamp) {
  CameraTiming timing;
  timing.delay = 0.012;
  timing.clockDrift = 0.001;
  EXPECT_NEAR(exposureTime(timing, 5.0), 5.0 - 0.012 - 0.005, 1e-12);
}

TEST(CalibrationErrors, HaveTheStatedSizes) {
  const Camera truth = scenarioRun("S0-slow").trueRig[0];
  Draws draws(5, "calibration test");
  EXPECT_EQ(miscalibrated(truth, {}, draws), truth);
  const CalibrationError error{0.005, 0.002, 0.003, 0.01};
  constexpr int kDraws = 2000;
  double focal = 0.0;
  double position = 0.0;
  double rotation = 0.0;
  double radial = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const Camera camera = miscalibrated(truth, error, draws);
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

TEST(Grades, DrawWithinTheirTables) {
  for (const Grade grade : {Grade::Room, Grade::Wild}) {
    const GradeModel& model = gradeModel(grade);
    FaultContext context;
    context.cameras = 3;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
      Draws draws(seed, "grade test");
      const SensingFaults faults = drawFaults(model, context, draws);
      ASSERT_EQ(faults.cameras.size(), 3U);
      EXPECT_FALSE(faults.illumination.plain());
      for (const CameraFaults& camera : faults.cameras) {
        const auto within = [](double value, const Range& range) {
          return value >= range.low && value <= range.high;
        };
        EXPECT_TRUE(within(camera.sensor.psfSigmaPx, model.psfSigmaPx));
        EXPECT_TRUE(within(camera.sensor.jpegQuality, model.jpegQuality));
        EXPECT_TRUE(within(camera.sensor.shutter.exposureSeconds, model.exposureSeconds));
        EXPECT_TRUE(within(camera.sensor.shutter.readoutSeconds, model.readoutSeconds));
        EXPECT_TRUE(within(camera.timing.delay * 30.0, model.delayFrames));
        EXPECT_LE(camera.sensor.drift.rotation.norm(), model.driftRadians.high + 1e-12);
        // The control is stable: speed < 2 sin(pi / (4 lag + 2)).
        const int lag = camera.automatic->exposure.lagFrames;
        EXPECT_LT(camera.automatic->exposure.speed, 2.0 * std::sin(M_PI / (4.0 * lag + 2.0)));
      }
    }
  }
}

/// Largest distance between the time stamps of the frames and of their sets in the first frames.
double largestStampError(const ScenarioRun& run) {
  double largest = 0.0;
  for (std::int64_t frame = 0; frame < 5; ++frame) {
    const FrameSetPtr set = run.frames(frame);
    for (const FramePtr& one : set->frames) {
      largest = one == nullptr ? largest
                               : std::max(largest, std::abs(seconds(one->captureTime - set->time)));
    }
  }
  return largest;
}

TEST(Grades, LampsLightTheTargetMoreThanFarWalls) {
  FaultContext context;
  context.cameras = 1;
  context.middle = {0.5, 0.5, 0.15};
  for (const Grade grade : {Grade::Room, Grade::Wild}) {
    Draws draws(4, "lamp test");
    for (const auto& lamp : drawFaults(gradeModel(grade), context, draws).illumination.further) {
      const float distance = (lamp.position - context.middle.cast<float>()).norm();
      EXPECT_FLOAT_EQ(lamp.falloff(distance), 1.0F);
      EXPECT_FLOAT_EQ(lamp.falloff(2.0F * distance), 0.25F);
    }
  }
}

/// How much the light of the rows of a camera's image swings in a grade, at most: amplitude of the
/// bands, of the mean light.
double strongestBands(Grade grade) {
  FaultContext context;
  context.cameras = 2;
  double most = 0.0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Draws draws(seed, "band test");
    for (const CameraFaults& camera : drawFaults(gradeModel(grade), context, draws).cameras) {
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

TEST(ScenarioCameraModel, LeavesTimeAndCalibrationIdeal) {
  for (const std::string name : {"S14-slow", "S14-fast"}) {
    const ScenarioRun run = scenarioRun(name);
    EXPECT_EQ(run.rig, run.trueRig);
    EXPECT_EQ(largestStampError(run), 0.0);
    EXPECT_EQ(run.frames(3)->frames[0]->image.size(), cv::Size(320, 240));
  }
}

TEST(ScenarioTiming, OneStreamFreezesForASecond) {
  const ScenarioRun run = scenarioRun("S15-frozen");
  // It begins between frames 60 and 90 and takes 30 frames.
  std::vector<int> repeated(2, 0);
  FrameSetPtr before = run.frames(58);
  for (std::int64_t frame = 59; frame < 122; ++frame) {
    const FrameSetPtr now = run.frames(frame);
    for (std::size_t camera = 0; camera < 2; ++camera) {
      ASSERT_NE(now->frames[camera], nullptr);
      EXPECT_EQ(now->frames[camera]->captureTime, now->time) << "new time stamps";
      const double difference =
          cv::norm(now->frames[camera]->image, before->frames[camera]->image, cv::NORM_INF);
      repeated[camera] += difference == 0.0 ? 1 : 0;
    }
    before = now;
  }
  EXPECT_EQ(std::min(repeated[0], repeated[1]), 0);
  EXPECT_EQ(std::max(repeated[0], repeated[1]), 30);
}

TEST(ScenarioTiming, SomeFramesAreDropped) {
  const ScenarioRun run = scenarioRun("S15-dropped");
  int dropped = 0;
  for (std::int64_t frame = 0; frame < 60; ++frame) {
    const FrameSetPtr set = run.frames(frame);
    for (const FramePtr& one : set->frames) {
      dropped += one == nullptr ? 1 : 0;
    }
  }
  EXPECT_GE(dropped, 3) << "a tenth of 118 is 12, with a standard deviation of 3.3";
  EXPECT_LE(dropped, 24);
}

/// How far the largest blob of a camera is behind the truth, in steps of the truth from frame to
/// frame: the mean over some frames.
double stepsBehind(const ScenarioRun& run, std::size_t camera) {
  const Projector projector(run.trueRig[camera]);
  const ColorClassifier classifier(run.targets[0].color);
  double sum = 0.0;
  int count = 0;
  for (std::int64_t frame = 10; frame < 60; frame += 7) {
    const auto blobs = findBlobs(matchImage(run.frames(frame)->frames[camera]->image, classifier));
    const auto at = [&](std::int64_t k) {
      return *projector.project(run.truth.samples.at(static_cast<std::size_t>(k)).position);
    };
    const Eigen::Vector2d step = at(frame) - at(frame - 1);
    if (!blobs.empty() && step.norm() > 10.0) {
      sum += (at(frame) - blobs[0].center).dot(step) / step.squaredNorm();
      ++count;
    }
  }
  EXPECT_GT(count, 2);
  return sum / std::max(1, count);
}

TEST(ScenarioTiming, UnknownDelaysAreUpToHalfAFrame) {
  const ScenarioRun late = scenarioRun("S15-offsets-fast");
  EXPECT_EQ(largestStampError(late), 0.0) << "the delay is unknown";
  for (std::size_t camera = 0; camera < 2; ++camera) {
    // The shaded rim shifts the blob by up to 2 px, a fifth of a step of 10 px.
    EXPECT_GT(stepsBehind(late, camera), -0.2);
    EXPECT_LT(stepsBehind(late, camera), 0.7);
  }
}

TEST(ScenarioCalibration, OnlyTheCalibrationIsWrong) {
  const ScenarioRun wrong = scenarioRun("S16-calibration");
  EXPECT_NE(wrong.rig[0], wrong.trueRig[0]);
  EXPECT_EQ(largestStampError(wrong), 0.0);
  const ScenarioRun drifting = scenarioRun("S16-drift");
  EXPECT_EQ(drifting.rig, drifting.trueRig) << "right at the beginning";
}

/// Share of the pixels of the ball's disc whose red has at least a level.
double clippedShare(const ScenarioRun& run, std::size_t camera, int level = 255) {
  const auto center = Projector(run.trueRig[camera]).project(run.truth.samples[0].position);
  const cv::Mat image = run.frames(0)->frames[camera]->image;
  int clipped = 0;
  int all = 0;
  for (int row = -12; row <= 12; ++row) {
    for (int column = -12; column <= 12; ++column) {
      const cv::Point pixel(static_cast<int>(center->x()) + column,
                            static_cast<int>(center->y()) + row);
      clipped += image.at<cv::Vec3b>(pixel)[2] >= level ? 1 : 0;
      ++all;
    }
  }
  return static_cast<double>(clipped) / all;
}

TEST(ScenarioIllumination, SideLightIsCut) {
  double most = 0.0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const ScenarioRun run = scenarioRun("S20-side-light", seed, Grade::Ideal);
    most = std::max({most, clippedShare(run, 0), clippedShare(run, 1)});
  }
  EXPECT_GT(most, 0.3) << "some camera of eight looks at the lit side";
  EXPECT_LT(clippedShare(scenarioRun("S0-slow"), 0), 0.1);
}

TEST(Grades, SideLightIsCutInSomeRunsOfRoom) {
  double most = 0.0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const ScenarioRun run = scenarioRun("S0-slow", seed, Grade::Room);
    // Noise, tone curve and JPEG take some levels from what was cut.
    most = std::max({most, clippedShare(run, 0, 248), clippedShare(run, 1, 248)});
  }
  EXPECT_GT(most, 0.05) << "in none of twelve rooms a lamp is strong and behind a camera";
}

TEST(ScenarioIllumination, FlickerMakesBandsThatTravel) {
  const ScenarioRun run = scenarioRun("S20-flicker");
  cv::Mat one;
  cv::Mat next;
  cv::reduce(run.frames(10)->frames[0]->image.reshape(1), one, 1, cv::REDUCE_AVG, CV_32F);
  cv::reduce(run.frames(11)->frames[0]->image.reshape(1), next, 1, cv::REDUCE_AVG, CV_32F);
  double low = 0.0;
  double high = 0.0;
  cv::minMaxLoc(next / one, &low, &high);
  // A swing of at least 0.2 x 0.757 (exposure of 0.4 periods) to both sides of linear light, a
  // third of a period apart from frame to frame: sqrt(3) x 0.15 to both sides, 0.45 of that in
  // levels.
  EXPECT_GT(high, 1.06);
  EXPECT_LT(low, 0.94);
}

TEST(ScenarioIllumination, AShadowPassesAndExposureJumps) {
  const auto meansOf = [](const ScenarioRun& run) {
    std::vector<double> means;
    for (std::int64_t frame = 0; frame < run.frameCount; frame += 9) {
      means.push_back(cv::mean(run.frames(frame)->frames[0]->image)[1]);
    }
    return means;
  };
  const auto shadow = meansOf(scenarioRun("S20-shadow"));
  EXPECT_LT(std::ranges::min(shadow), 0.99 * std::ranges::max(shadow));
  const auto steps = meansOf(scenarioRun("S20-exposure-steps"));
  EXPECT_LT(std::ranges::min(steps), 0.95 * std::ranges::max(steps));
  EXPECT_NEAR(steps[0], steps[2], 0.01 * steps[0]) << "no step before frame 20";
}

} // namespace
} // namespace dewpoint::tests
