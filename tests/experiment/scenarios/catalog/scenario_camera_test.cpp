// SPDX-License-Identifier: GPL-3.0-or-later
// Scenarios about what a camera makes of the light, S14, when it does, S15, and what is known of
// where it stands, S16.
#include "core/base/time.h"
#include "core/experiment/baselines/baseline_blobs.h"
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/draft_frames.h"
#include "core/experiment/scenarios/pink_target.h"
#include "core/simulation/sensor/camera_drift.h"
#include "tests/experiment/scenarios/scenario_drafts.h"
#include "tests/experiment/scenarios/scenario_images.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace dewpoint::tests {
namespace {

using experiment::scenarios::CalibrationError;
using experiment::scenarios::CameraFaults;

/// Mean difference of two images, gray levels.
double differenceOf(const cv::Mat& one, const cv::Mat& other) {
  return cv::norm(one, other, cv::NORM_L1) / static_cast<double>(one.total() * 3);
}

/// How much the scenario's faults change an image; both have the same noise.
double changeOf(const ScenarioDraft& draft, std::size_t camera, std::int64_t frame) {
  return differenceOf(frameSetOf(draft, frame)->frames.at(camera)->image,
                      frameSetOf(withFaults(draft), frame)->frames.at(camera)->image);
}

void expectWithin(double value, double low, double high, const std::string& what) {
  EXPECT_GE(value, low) << what;
  EXPECT_LE(value, high) << what;
}

TEST(ScenarioCameraModel, LeavesTimeAndCalibrationIdeal) {
  for (const std::string name : {"S14-slow", "S14-fast"}) {
    const ScenarioRun run = scenarioRun(name);
    EXPECT_EQ(run.rig, run.trueRig);
    EXPECT_EQ(largestStampError(run), 0.0);
    EXPECT_EQ(run.frames(3)->frames[0]->image.size(), cv::Size(320, 240));
  }
}

TEST(ScenarioCameraModel, HasTheLensesAndSensorsOfRoom) {
  for (const std::string name : {"S14-slow", "S14-fast"}) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const auto faults = faultsOf(draftOf(experiment::scenarios::sensorScenarios(), name, seed));
      ASSERT_EQ(faults.cameras.size(), 2U);
      EXPECT_TRUE(faults.illumination.isDefault());
      for (const CameraFaults& camera : faults.cameras) {
        expectWithin(camera.sensor.psfSigmaPx, 0.5, 2.0, name);
        expectWithin(camera.sensor.noise.fullWellElectrons, 1000.0, 6000.0, name);
        expectWithin(camera.sensor.noise.readNoiseElectrons, 2.0, 6.0, name);
        expectWithin(camera.sensor.sharpening.amount, 0.2, 1.0, name);
        expectWithin(camera.sensor.jpegQuality, 40, 90, name);
        EXPECT_EQ(camera.sensor.contrast, 1.0);
        EXPECT_EQ(camera.sensor.shutter.readoutSeconds, 0.0);
        EXPECT_EQ(camera.sensor.drift.rotation, Eigen::Vector3d::Zero());
        EXPECT_FALSE(camera.automaticGain);
      }
    }
  }
}

/// Of the steps of 40 gray levels or more between neighbors of a row, the share that another image
/// of the same scene has there. A softer image spreads them over more pixels.
double keptSteps(const cv::Mat& sharp, const cv::Mat& image) {
  double kept = 0.0;
  double all = 0.0;
  int steps = 0;
  for (int row = 0; row < sharp.rows; ++row) {
    for (int column = 0; column + 1 < sharp.cols; ++column) {
      const auto stepOf = [&](const cv::Mat& of) {
        return static_cast<double>(of.at<cv::Vec3b>(row, column + 1)[1] -
                                   of.at<cv::Vec3b>(row, column)[1]);
      };
      if (std::abs(stepOf(sharp)) >= 40.0) {
        kept += std::copysign(1.0, stepOf(sharp)) * stepOf(image);
        all += std::abs(stepOf(sharp));
        ++steps;
      }
    }
  }
  EXPECT_GT(steps, 100) << "books and boxes have edges";
  return kept / std::max(1.0, all);
}

TEST(ScenarioCameraModel, ItsImagesAreSofterThanIdealOnes) {
  double kept = 0.0;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    ScenarioDraft draft = draftOf(experiment::scenarios::sensorScenarios(), "S14-slow", seed);
    draft.stage.noiseSigma = 0.0; // of the ideal camera; the other has its own
    const ScenarioDraft webcams = withFaults(draft);
    for (const std::size_t camera : {0U, 1U}) {
      kept += keptSteps(imageOf(draft, camera, 0), imageOf(webcams, camera, 0)) / 6.0;
    }
  }
  // Computed for edges from level 60 to 160, with mosaic, sharpening of 0.2 to 1 and JPEG of 40 to
  // 90: 0.41 to 0.78 of a step is left by a blur of 0.5 px, 0.26 to 0.37 by 1.25 px, 0.17 to 0.23
  // by 2 px, and 0.53 to 1.02 without any.
  EXPECT_LT(kept, 0.55);
  EXPECT_GT(kept, 0.1);
}

/// How much the noise of a pixel goes with that of its right neighbor: the correlation of the
/// difference of two images of one scene, over all cameras.
double noiseOfNeighbors(const ScenarioDraft& draft) {
  double own = 0.0;
  double both = 0.0;
  for (std::size_t camera = 0; camera < draft.rig.size(); ++camera) {
    cv::Mat noise;
    cv::subtract(imageOf(draft, camera, 0, 1), imageOf(draft, camera, 0, 2), noise, cv::noArray(),
                 CV_32F);
    const cv::Mat left = noise.colRange(0, noise.cols - 1).clone();
    const cv::Mat right = noise.colRange(1, noise.cols).clone();
    own += left.dot(left);
    both += left.dot(right);
  }
  EXPECT_GT(own, 0.0);
  return both / std::max(1.0, own);
}

// In gray levels a webcam's noise is about that of the ideal camera, 3; but mosaic and JPEG spread
// it over neighbors, so that a mean over pixels takes less of it away.
TEST(ScenarioCameraModel, ItsNoiseGoesOverSeveralPixels) {
  const ScenarioDraft ideal = draftOf(experiment::scenarios::cleanScenarios(), "S0-slow");
  EXPECT_NEAR(noiseOfNeighbors(ideal), 0.0, 0.03); // of 450,000 pairs: 0.0015
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    // Computed for gray areas with and without texture, 1000 to 6000 electrons, JPEG of 40 to 90:
    // 0.37 to 0.8.
    EXPECT_GT(noiseOfNeighbors(
                  withFaults(draftOf(experiment::scenarios::sensorScenarios(), "S14-slow", seed))),
              0.25);
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

/// How many frames before its time stamp an image was taken, by where its largest blob is: least
/// squares along the ball's motion over one round, 36 frames. What shifts a blob the same way all
/// the time, as its shaded side does, cancels, because the velocities of a round add up to nothing.
double framesBehind(const ScenarioDraft& draft, std::size_t camera) {
  const Projector projector(draft.rig[camera]);
  const ColorClassifier classifier(experiment::scenarios::pinkTarget("", 0.0).color);
  const auto at = [&](double frame) {
    const auto& path = draft.stage.bodies.at(draft.targets.front()).path;
    return *projector.project(path(frame / draft.framesPerSecond));
  };
  double along = 0.0;
  double squares = 0.0;
  for (std::int64_t frame = 0; frame < 36; frame += 4) {
    const auto blobs =
        findBlobs(matchImage(frameSetOf(draft, frame)->frames.at(camera)->image, classifier));
    EXPECT_FALSE(blobs.empty());
    const auto number = static_cast<double>(frame);
    const Eigen::Vector2d step = (at(number + 0.01) - at(number - 0.01)) / 0.02; // per frame
    along += blobs.empty() ? 0.0 : (at(number) - blobs[0].center).dot(step);
    squares += step.squaredNorm();
  }
  return along / squares;
}

TEST(ScenarioTiming, UnknownDelaysAreUpToHalfAFrame) {
  EXPECT_EQ(largestStampError(scenarioRun("S15-offsets-fast")), 0.0) << "the delay is unknown";
  double most = 0.0;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const ScenarioDraft draft =
        draftOf(experiment::scenarios::timingScenarios(), "S15-offsets-fast", seed);
    const SensingFaults faults = faultsOf(draft);
    for (const std::size_t camera : {0U, 1U}) {
      const double delay = 30.0 * faults.cameras.at(camera).timing.delaySeconds;
      expectWithin(delay, 0.0, 0.5, draft.name);
      // A blob is found to 2 px, of which most cancels; the steps are 20 to 40 px.
      EXPECT_NEAR(framesBehind(withFaults(draft), camera), delay, 0.1);
      most = std::max(most, delay);
    }
  }
  EXPECT_GT(most, 0.1) << "six draws between 0 and 0.5 frames";
  const ScenarioDraft exact = draftOf(experiment::scenarios::cleanScenarios(), "S0-fast");
  EXPECT_NEAR(framesBehind(exact, 0), 0.0, 0.1);
}

TEST(ScenarioTiming, RollingShuttersReadOutIn15To30Milliseconds) {
  for (const std::string name : {"S15-rolling-slow", "S15-rolling-fast"}) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const ScenarioDraft draft = draftOf(experiment::scenarios::timingScenarios(), name, seed);
      for (const CameraFaults& camera : faultsOf(draft).cameras) {
        expectWithin(camera.sensor.shutter.readoutSeconds, 0.015, 0.030, name);
        EXPECT_EQ(camera.timing.delaySeconds, 0.0);
        EXPECT_EQ(camera.timing.clockDrift, 0.0);
      }
    }
  }
  const ScenarioDraft fast = draftOf(experiment::scenarios::timingScenarios(), "S15-rolling-fast");
  for (const std::size_t camera : {0U, 1U}) {
    EXPECT_GT(changeOf(fast, camera, 10), 0.0) << "most rows are not taken at the set's time";
  }
}

TEST(ScenarioTiming, ClocksGoWrongByUpToTwoThousandths) {
  double most = 0.0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const ScenarioDraft draft =
        draftOf(experiment::scenarios::timingScenarios(), "S15-clock-drift", seed);
    for (const CameraFaults& camera : faultsOf(draft).cameras) {
      expectWithin(camera.timing.clockDrift, -0.002, 0.002, draft.name);
      EXPECT_EQ(camera.timing.delaySeconds, 0.0);
      EXPECT_EQ(camera.sensor.shutter.readoutSeconds, 0.0);
      most = std::max(most, std::abs(camera.timing.clockDrift));
    }
  }
  EXPECT_GT(most, 0.001) << "ten draws";
  const ScenarioDraft draft = draftOf(experiment::scenarios::timingScenarios(), "S15-clock-drift");
  for (const std::size_t camera : {0U, 1U}) {
    EXPECT_EQ(changeOf(draft, camera, 0), 0.0);
    EXPECT_GT(changeOf(draft, camera, 179), 0.0) << "up to 12 ms late or early";
  }
}

TEST(ScenarioCalibration, OnlyTheCalibrationIsWrong) {
  const ScenarioRun wrong = scenarioRun("S16-calibration");
  EXPECT_NE(wrong.rig[0], wrong.trueRig[0]);
  EXPECT_EQ(largestStampError(wrong), 0.0);
  const ScenarioRun drifting = scenarioRun("S16-drift");
  EXPECT_EQ(drifting.rig, drifting.trueRig) << "right at the beginning";
  const ScenarioRun both = scenarioRun("S16-both");
  EXPECT_NE(both.rig[0], both.trueRig[0]);
  EXPECT_EQ(largestStampError(both), 0.0);
}

/// Where a camera looks at a frame: a direction d is seen where the camera at rest sees R d.
Eigen::Matrix3d trueRotation(const ScenarioDraft& draft, std::size_t camera, std::int64_t frame) {
  const auto& drift = draft.stage.sensors.at(camera).drift;
  return draft.rig[camera].cameraFromWorld.linear() *
         simulation::rotationAt(drift, draft.timeOf(frame));
}

double angleBetween(const Eigen::Matrix3d& one, const Eigen::Matrix3d& other) {
  return Eigen::AngleAxisd(Eigen::Matrix3d(one * other.transpose())).angle();
}

TEST(ScenarioCalibration, CamerasRotateAwayFromWhatIsGiven) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    CameraRig given;
    const ScenarioDraft draft =
        withFaults(draftOf(experiment::scenarios::driftScenarios(), "S16-drift", seed), &given);
    for (std::size_t camera = 0; camera < 2; ++camera) {
      const Eigen::Matrix3d believed = given[camera].cameraFromWorld.linear();
      EXPECT_LT(angleBetween(trueRotation(draft, camera, 0), believed), 1e-7);
      // 1 to 3 mrad, of which 1 - exp(-5.97 s / 4 s) = 0.775 at least are reached.
      expectWithin(angleBetween(trueRotation(draft, camera, 179), believed), 0.77e-3, 3.0e-3,
                   draft.name);
    }
  }
  const ScenarioDraft draft = draftOf(experiment::scenarios::driftScenarios(), "S16-drift");
  for (const std::size_t camera : {0U, 1U}) {
    EXPECT_EQ(changeOf(draft, camera, 0), 0.0);
    // 0.27 px at least, or 0.1 px near the borders about the optical axis, of a cluttered desk.
    EXPECT_GT(changeOf(draft, camera, 179), 0.05);
  }
}

TEST(ScenarioCalibration, BothAreWrongInBoth) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  const CalibrationError room{0.005, 0.002, 0.2 * kDegree, 0.01};
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    CameraRig given;
    const ScenarioDraft plain = draftOf(experiment::scenarios::driftScenarios(), "S16-both", seed);
    const ScenarioDraft draft = withFaults(plain, &given);
    for (std::size_t camera = 0; camera < 2; ++camera) {
      EXPECT_EQ(faultsOf(plain).cameras.at(camera).calibration, room);
      EXPECT_NE(given[camera], draft.rig[camera]);
      // The drift comes on top, about another axis: it may even lead back.
      expectWithin(angleBetween(trueRotation(draft, camera, 179), trueRotation(draft, camera, 0)),
                   0.77e-3, 3.0e-3, draft.name);
    }
  }
}

} // namespace
} // namespace dewpoint::tests
