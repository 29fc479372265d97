// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/suite_recorder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

constexpr std::int64_t kFrames = 20;

/// Targets at rest at (0, 0, 0), (1, 0, 0), ...; the camera looks along +y.
ScenarioRun restingRun(std::size_t targetCount) {
  ScenarioRun run;
  run.scenario = "S0-test";
  run.seed = 5;
  Camera camera;
  camera.cameraFromWorld = lookAt({0, -1, 0}, {0, 0, 0});
  run.rig = run.trueRig = {camera};
  run.frameCount = kFrames;
  for (std::size_t k = 0; k < targetCount; ++k) {
    run.targets.push_back({"ball " + std::to_string(k), 0.02, ColorRange{}});
    for (std::int64_t frame = 0; frame < kFrames; ++frame) {
      TrajectorySample sample;
      sample.frame = frame;
      sample.target = run.targets.back().name;
      sample.position = Eigen::Vector3d(static_cast<double>(k), 0.0, 0.0);
      run.truth.samples.push_back(sample);
    }
  }
  return run;
}

SphereEstimate estimateAt(const Eigen::Vector3d& place, double sigma = 0.003) {
  SphereEstimate estimate;
  estimate.mean = place;
  estimate.covariance = sigma * sigma * Eigen::Matrix3d::Identity();
  estimate.isValid = true;
  estimate.existenceProbability = 1.0;
  return estimate;
}

TEST(SuiteRecorder, SplitsAConstantError) {
  // 4 mm along the camera's axis and 3 mm across: 5 mm in all; normalized with 3 mm per axis it is
  // 25 / 9, inside the 95 % ellipsoid (7.81) but outside the 50 % one (2.37). The stated radius is
  // sqrt(3) * 3 mm = 5.2 mm.
  const ScenarioRun run = restingRun(1);
  SuiteRecorder recorder(run, "test");
  for (std::int64_t k = 0; k < kFrames; ++k) {
    recorder.add({estimateAt({0.003, 0.004, 0.0})});
  }
  const SuiteRow row = recorder.result(12.0).row;
  EXPECT_EQ(row.key, (RunKey{"S0-test", Grade::Ideal, "test", 5}));
  EXPECT_NEAR(*row.rmseMm, 5.0, 1e-9);
  EXPECT_NEAR(*row.medianErrorMm, 5.0, 1e-9);
  EXPECT_NEAR(*row.biasMm, 5.0, 1e-9);
  EXPECT_NEAR(*row.depthErrorMm, 4.0, 1e-9);
  EXPECT_NEAR(*row.depthBiasMm, 4.0, 1e-9);
  EXPECT_NEAR(*row.lateralErrorMm, 3.0, 1e-9);
  EXPECT_NEAR(*row.nees, 25.0 / 9.0, 1e-9);
  EXPECT_EQ(*row.coverage95Percent, 100.0);
  EXPECT_EQ(*row.coverage50Percent, 0.0);
  EXPECT_EQ(*row.confidentlyWrongPercent, 0.0);
  EXPECT_EQ(*row.wrongPercent, 0.0);
  EXPECT_EQ(*row.wrongWhenConfidentPercent, 0.0);
  EXPECT_EQ(*row.framesToConverge, 0.0);
  EXPECT_EQ(*row.lostPercent, 0.0);
  EXPECT_EQ(*row.falseAlarmPercent, 0.0);
  EXPECT_EQ(*row.existenceEce, 0.0);
  EXPECT_EQ(*row.mota, 1.0);
  EXPECT_EQ(*row.usPerFrame, 12.0);
  EXPECT_EQ(*row.frameCount, kFrames);
  EXPECT_FALSE(row.framesToReacquire || row.framesToDeclareLoss || row.blackoutRmseMm ||
               row.largestStepMm)
      << "nothing happened that they could refer to";
}

TEST(SuiteRecorder, CountsFromConvergenceOn) {
  // 4 frames far away, 11 good ones, 5 without an estimate.
  const ScenarioRun run = restingRun(1);
  SuiteRecorder recorder(run, "test");
  for (std::int64_t k = 0; k < kFrames; ++k) {
    SphereEstimate estimate = estimateAt({k < 4 ? 0.5 : 0.002, 0.0, 0.0});
    estimate.isValid = k < 15;
    estimate.existenceProbability = k < 15 ? 1.0 : 0.0;
    recorder.add({estimate});
  }
  const SuiteResult result = recorder.result(0.0);
  EXPECT_EQ(*result.row.framesToConverge, 4.0);
  EXPECT_NEAR(*result.row.rmseMm, 2.0, 1e-9);
  EXPECT_NEAR(*result.row.lostPercent, 100.0 * 5.0 / 16.0, 1e-9);
  EXPECT_NEAR(*result.row.falseAlarmPercent, 100.0 * 4.0 / 20.0, 1e-9);
  EXPECT_NEAR(*result.row.confidentlyWrongPercent, 20.0, 1e-9) << "belief counts from the start";
  EXPECT_NEAR(*result.row.wrongPercent, 20.0, 1e-9);
  ASSERT_EQ(result.trace.errorsMm.size(), 1U);
  EXPECT_NEAR(result.trace.errorsMm[0][0], 500.0, 1e-9);
  EXPECT_TRUE(std::isnan(result.trace.errorsMm[0][19]));
}

TEST(SuiteRecorder, NeverConvergedIsInfinite) {
  const ScenarioRun run = restingRun(1);
  SuiteRecorder recorder(run, "test");
  for (std::int64_t k = 0; k < kFrames; ++k) {
    recorder.add({SphereEstimate{}});
  }
  const SuiteRow row = recorder.result(0.0).row;
  EXPECT_TRUE(std::isinf(*row.framesToConverge));
  EXPECT_EQ(*row.lostPercent, 100.0);
  EXPECT_FALSE(row.rmseMm.has_value());
  EXPECT_EQ(*row.confidentlyWrongPercent, 0.0) << "it states nothing";
}

TEST(SuiteRecorder, TellsSureFromWrong) {
  // Of 20 frames: 8 right, 4 wrong by 50 mm and sure, 3 as wrong with P = 0.9, 5 sure and 20 mm off
  // at a stated radius of sqrt(3) * 3 mm = 5.2 mm, three of which are 15.6 mm.
  const ScenarioRun run = restingRun(1);
  SuiteRecorder recorder(run, "test");
  for (std::int64_t k = 0; k < kFrames; ++k) {
    SphereEstimate estimate = estimateAt({k < 8 ? 0.0 : k < 15 ? 0.05 : 0.02, 0.0, 0.0});
    estimate.existenceProbability = k >= 12 && k < 15 ? 0.9 : 1.0;
    recorder.add({estimate});
  }
  const SuiteRow row = recorder.result(0.0).row;
  EXPECT_NEAR(*row.wrongPercent, 35.0, 1e-9);
  EXPECT_NEAR(*row.wrongWhenConfidentPercent, 20.0, 1e-9);
  EXPECT_NEAR(*row.confidentlyWrongPercent, 45.0, 1e-9);
}

TEST(SuiteRecorder, JitterIsTheNoiseOfSuccessiveFrames) {
  // From convergence on 2, 0, 2, 0, ... mm: second differences of 4 mm, sqrt(16 / 6). In the middle
  // a frame without an estimate: the differences about it are left out.
  const ScenarioRun run = restingRun(1);
  SuiteRecorder recorder(run, "test");
  for (std::int64_t k = 0; k < kFrames; ++k) {
    SphereEstimate estimate = estimateAt({k < 3 ? 0.5 : k % 2 == 0 ? 0.002 : 0.0, 0.0, 0.0});
    estimate.isValid = k != 12;
    estimate.existenceProbability = k != 12 ? 1.0 : 0.0;
    recorder.add({estimate});
  }
  EXPECT_NEAR(*recorder.result(0.0).row.jitterMm, std::sqrt(16.0 / 6.0), 1e-9);
}

TEST(SuiteRecorder, ComparesWithTheExtent) {
  // An ellipsoid with semi-axes of 80, 20 and 20 mm: a quarter is 20 mm; the ball of its volume has
  // 32 mm. 10 frames 10 mm off, 6 frames 25 mm, 4 without an estimate.
  ScenarioRun run = restingRun(1);
  run.targets[0].radius = 0.0;
  run.extents.assign(run.truth.samples.size(), {0.032, {0.08, 0.02, 0.02}});
  SuiteRecorder recorder(run, "test");
  for (std::int64_t k = 0; k < kFrames; ++k) {
    SphereEstimate estimate = estimateAt({k < 10 ? 0.010 : 0.025, 0.0, 0.0});
    estimate.radius = 0.04;
    estimate.isValid = k < 16;
    estimate.existenceProbability = k < 16 ? 1.0 : 0.0;
    recorder.add({estimate});
  }
  const SuiteRow row = recorder.result(0.0).row;
  EXPECT_NEAR(*row.nearCentroidPercent, 50.0, 1e-9);
  EXPECT_NEAR(*row.centroidErrorPercent, 12.5, 1e-9);
  EXPECT_NEAR(*row.sizeErrorPercent, 25.0, 1e-9);
}

TEST(SuiteRecorder, SizeCountsWhereItIsEstimated) {
  ScenarioRun run = restingRun(1); // the radius is given
  SuiteRecorder without(run, "test");
  run.extents.assign(run.truth.samples.size(), {0.02, {0.02, 0.02, 0.02}});
  SuiteRecorder given(run, "test");
  ScenarioRun unknown = run;
  unknown.targets[0].radius = 0.0;
  SuiteRecorder silent(unknown, "test");
  for (std::int64_t k = 0; k < kFrames; ++k) {
    SphereEstimate estimate = estimateAt({0.001, 0.0, 0.0});
    silent.add({estimate}); // such as triangulation: radius 0
    estimate.radius = 0.02;
    without.add({estimate});
    given.add({estimate});
  }
  EXPECT_FALSE(without.result(0.0).row.nearCentroidPercent.has_value()) << "no extent is told";
  EXPECT_FALSE(given.result(0.0).row.sizeErrorPercent.has_value());
  EXPECT_NEAR(*given.result(0.0).row.centroidErrorPercent, 5.0, 1e-9);
  EXPECT_FALSE(silent.result(0.0).row.sizeErrorPercent.has_value());
  EXPECT_EQ(*silent.result(0.0).row.nearCentroidPercent, 100.0);
}

TEST(SuiteRecorder, NobodyMayBeSureOfATie) {
  // Of 20 frames: 12 with P = 0.5, 5 with 0.9, 3 silent. The estimate is always right.
  ScenarioRun run = restingRun(1);
  const auto rowOf = [&](int equalCandidateCount) {
    run.equalCandidateCount = equalCandidateCount;
    SuiteRecorder recorder(run, "test");
    for (std::int64_t k = 0; k < kFrames; ++k) {
      SphereEstimate estimate = estimateAt({0.0, 0.0, 0.0});
      estimate.existenceProbability = k < 12 ? 0.5 : k < 17 ? 0.9 : 0.0;
      estimate.isValid = k < 17;
      recorder.add({estimate});
    }
    return recorder.result(0.0).row;
  };
  EXPECT_FALSE(rowOf(1).confidentInTiePercent.has_value()) << "nothing is tied";
  EXPECT_NEAR(*rowOf(2).confidentInTiePercent, 25.0, 1e-9);
  EXPECT_NEAR(*rowOf(3).confidentInTiePercent, 85.0, 1e-9);
  EXPECT_NEAR(*rowOf(2).wrongPercent, 0.0, 1e-9);
}

TEST(SuiteRecorder, MeasuresEvents) {
  ScenarioRun run = restingRun(1);
  using Kind = ScenarioEvent::Kind;
  run.events = {{Kind::BlackoutBegin, 6, 0}, {Kind::BlackoutEnd, 8, 0}, {Kind::CameraLost, 12, 0}};
  SuiteRecorder recorder(run, "test");
  for (std::int64_t k = 0; k < kFrames; ++k) {
    // 10 and 20 mm in the blackout, 50 mm in the frame after it, a step of 3 mm at frame 12.
    const double error = k == 6 ? 0.010 : k == 7 ? 0.020 : k == 8 ? 0.050 : k < 12 ? 0.0 : 0.003;
    recorder.add({estimateAt({k == 8 ? error : 0.0, k == 8 ? 0.0 : error, 0.0})});
  }
  const SuiteRow row = recorder.result(0.0).row;
  EXPECT_EQ(*row.framesToReacquire, 1.0);
  EXPECT_NEAR(*row.blackoutRmseMm, std::sqrt(250.0), 1e-9);
  // Mean of the five frames before: (20 mm in depth + 50 mm across) / 5.
  EXPECT_NEAR(*row.largestStepMm, std::hypot(3.0 - 4.0, 10.0), 1e-9);
}

TEST(SuiteRecorder, FramesOutOfViewAreNotLost) {
  ScenarioRun run = restingRun(1);
  using Kind = ScenarioEvent::Kind;
  run.events = {{Kind::UnseenBegin, 6, 0}, // one camera of several: the target is still to be seen
                {Kind::UnseenBegin, 8, -1},
                {Kind::UnseenEnd, 12, -1},
                {Kind::UnseenEnd, 12, 0}};
  SuiteRecorder recorder(run, "test");
  for (std::int64_t k = 0; k < kFrames; ++k) {
    SphereEstimate estimate = estimateAt({0, 0, 0});
    estimate.isValid = k < 7 || k >= 14;
    estimate.existenceProbability = estimate.isValid ? 1.0 : 0.0;
    recorder.add({estimate});
  }
  const SuiteRow row = recorder.result(0.0).row;
  // Of 16 frames in view the 8th, the 13th and the 14th are without an estimate.
  EXPECT_NEAR(*row.lostPercent, 100.0 * 3.0 / 16.0, 1e-9);
  EXPECT_EQ(*row.framesToReacquire, 2.0);
}

TEST(SuiteRecorder, LossHasToBeDeclared) {
  ScenarioRun run = restingRun(1);
  run.events = {{ScenarioEvent::Kind::Vanish, 10, -1}};
  for (TrajectorySample& sample : run.truth.samples) {
    sample.isValid = sample.frame < 10;
  }
  SuiteRecorder recorder(run, "test");
  for (std::int64_t k = 0; k < kFrames; ++k) {
    SphereEstimate estimate = estimateAt({0, 0, 0});
    estimate.isValid = k < 12;
    estimate.existenceProbability = k < 12 ? 1.0 : 0.0;
    recorder.add({estimate});
  }
  const SuiteRow row = recorder.result(0.0).row;
  EXPECT_EQ(*row.framesToDeclareLoss, 2.0);
  EXPECT_NEAR(*row.falseAlarmPercent, 10.0, 1e-9);
  // 12 forecasts of 1 of which 10 came true, 8 of 0: ECE is 2 / 20.
  EXPECT_NEAR(*row.existenceEce, 0.1, 1e-9);
  EXPECT_NEAR(*row.confidentlyWrongPercent, 10.0, 1e-9) << "two frames of 20 without the target";
  EXPECT_NEAR(*row.wrongPercent, 10.0, 1e-9);
}

TEST(SuiteRecorder, NamesOfIdenticalTargetsAreTheMethods) {
  // The method has the two the other way round all the time, then mixes them up for 4 frames.
  const ScenarioRun run = restingRun(2);
  SuiteRecorder recorder(run, "test");
  for (std::int64_t k = 0; k < kFrames; ++k) {
    const bool mixed = k >= 16;
    recorder.add(
        {estimateAt({mixed ? 0.0 : 1.0, 0.0, 0.001}), estimateAt({mixed ? 1.0 : 0.0, 0.0, 0.001})});
  }
  const SuiteRow row = recorder.result(0.0).row;
  EXPECT_EQ(*row.framesToConverge, 0.0);
  EXPECT_EQ(*row.identitySwitches, 2.0);
  EXPECT_NEAR(*row.lostPercent, 20.0, 1e-9);
  EXPECT_NEAR(*row.medianErrorMm, 1.0, 1e-9);
  EXPECT_NEAR(*row.confidentlyWrongPercent, 20.0, 1e-9) << "each target counts in each frame";
}

} // namespace
} // namespace dewpoint::tests
