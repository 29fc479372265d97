// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/calibration/wand/time_offset_search.h"
#include "core/calibration/wand/wand_calibration.h"
#include "core/calibration/wand/wand_gauge.h"
#include "core/geometry/sphere_image.h"
#include "tests/calibration/moved_cameras.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dewpoint::tests {
namespace {

CameraRig trueRig() {
  CameraRig rig;
  const std::vector<Eigen::Vector3d> places{
      {2.0, 2.0, 1.9}, {-2.0, 2.0, 1.7}, {-2.0, -2.0, 1.8}, {2.0, -2.0, 1.6}};
  for (const auto& place : places) {
    Camera camera;
    camera.name = "camera " + std::to_string(rig.size() + 1);
    camera.intrinsics = {640, 480, 450.0, 450.0, 320.0, 240.0};
    camera.cameraFromWorld = lookAt(place, {0.0, 0.0, 0.8});
    rig.push_back(camera);
  }
  return rig;
}

constexpr double kWandLength = 0.6;
constexpr double kWandRadius = 0.04;

Eigen::Vector3d wavedAt(double t, std::size_t ball) {
  const Eigen::Vector3d middle(0.8 * std::sin(1.3 * t), 0.8 * std::sin(1.7 * t + 0.5),
                               1.0 + 0.5 * std::sin(1.1 * t + 1.0));
  const Eigen::Vector3d along(std::cos(0.9 * t), std::sin(0.9 * t) * std::cos(0.7 * t),
                              std::sin(0.9 * t) * std::sin(0.7 * t));
  return middle + (ball == 0 ? -0.5 : 0.5) * kWandLength * along;
}

using Path = Eigen::Vector3d (*)(double, std::size_t);

WandProblem waveWand(const CameraRig& rig, std::size_t balls, double noise, int frames = 200,
                     const std::vector<double>& offsets = {0.0, 0.0, 0.0, 0.0},
                     Path path = wavedAt) {
  WandProblem problem;
  problem.views.resize(rig.size());
  problem.ballRadii = {kWandRadius, kWandRadius};
  problem.stickLength = balls == 2 ? kWandLength : 0.0;
  const RandomStream random(9, 0, 0, RandomPurpose::Noise);
  std::uint32_t count = 0;
  for (std::size_t c = 0; c < rig.size(); ++c) {
    const SphereProjector projector(rig[c]);
    for (int f = 0; f < frames; ++f) {
      for (std::size_t ball = 0; ball < balls; ++ball) {
        const double time = f / 15.0;
        const auto image = projector.project(path(time + offsets[c], ball), kWandRadius);
        const auto draw = random.normal4(count++);
        if (image && image->center.x() > 0 && image->center.x() < 640 && image->center.y() > 0 &&
            image->center.y() < 480) {
          problem.views[c].push_back({time, ball,
                                      image->center + noise * Eigen::Vector2d(draw[0], draw[1]),
                                      image->radius, std::max(noise, 0.05)});
        }
      }
    }
  }
  return problem;
}

/// Largest distance between cameras of the same number after the best rigid motion.
double misplacement(const CameraRig& found, const CameraRig& truth) {
  const Similarity change = fitRigSimilarity(found, truth, false);
  double worst = 0.0;
  for (std::size_t c = 0; c < truth.size(); ++c) {
    worst = std::max(worst, (change * found[c].center() - truth[c].center()).norm());
  }
  return worst;
}

TEST(WandCalibration, AStickGivesTheRigBack) {
  const CameraRig rig = trueRig();
  WandProblem problem = waveWand(rig, 2, 0.0);
  problem.initialRig = movedCameras(rig, 0.1, 0.05, 0);
  const auto result = calibrateFromWand(problem);
  ASSERT_TRUE(result) << errorSentence(result.error());
  EXPECT_LT(misplacement(result->cameras, rig), 1e-5);
  EXPECT_LT(result->medianResidualPx, 1e-3);
  EXPECT_EQ(result->scaleMethod, WandScale::Stick);
  EXPECT_EQ(result->cameras[2].name, "camera 3");
  const auto again = calibrateFromWand(problem);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->cameras, result->cameras);
}

TEST(WandCalibration, HalfAPixelOfNoiseIsMillimeters) {
  const CameraRig rig = trueRig();
  WandProblem problem = waveWand(rig, 2, 0.3);
  problem.initialRig = movedCameras(rig, 0.3, 10.0 / 180.0 * std::numbers::pi, 0);
  problem.initialPositionError = 0.3;
  problem.initialRotationError = 0.17;
  const auto result = calibrateFromWand(problem);
  ASSERT_TRUE(result) << errorSentence(result.error());
  EXPECT_LT(misplacement(result->cameras, rig), 2e-3);
  EXPECT_NEAR(result->bundle.residualToSigmaRatio, 1.0, 0.1);
}

TEST(WandCalibration, GrossErrorsAreDropped) {
  const CameraRig rig = trueRig();
  WandProblem problem = waveWand(rig, 2, 0.2);
  const RandomStream random(13, 0, 0, RandomPurpose::Noise);
  std::size_t wrong = 0;
  std::size_t total = 0;
  for (auto& views : problem.views) {
    for (MarkerObservation& view : views) {
      if (random.uniform(std::uint32_t(total)) < 0.05) {
        view.pixel = {640.0 * random.uniform(std::uint32_t(total), 1),
                      480.0 * random.uniform(std::uint32_t(total), 2)};
        ++wrong;
      }
      ++total;
    }
  }
  problem.initialRig = movedCameras(rig, 0.1, 0.05, 0);
  const auto result = calibrateFromWand(problem);
  ASSERT_TRUE(result) << errorSentence(result.error());
  EXPECT_LT(misplacement(result->cameras, rig), 3e-3);
  std::size_t dropped = 0;
  for (const std::size_t count : result->droppedViewCounts) {
    dropped += count;
  }
  EXPECT_GE(double(dropped), 0.8 * double(wrong));
  EXPECT_LE(double(dropped), 1.3 * double(wrong));
}

TEST(WandCalibration, FindsOffsetsAndFocalLengths) {
  const CameraRig rig = trueRig();
  const std::vector<double> offsets{0.0, 0.016, -0.016, 0.007};
  WandProblem problem = waveWand(rig, 2, 0.1, 300, offsets);
  problem.initialRig = movedCameras(rig, 0.1, 0.05, 0);
  for (Camera& camera : problem.initialRig) {
    camera.intrinsics.focalX *= 0.98;
    camera.intrinsics.focalY *= 0.98;
  }
  problem.estimatesTimeOffsets = true;
  problem.estimatesFocalLengths = true;
  const auto result = calibrateFromWand(problem);
  ASSERT_TRUE(result) << errorSentence(result.error());
  for (std::size_t c = 0; c < rig.size(); ++c) {
    EXPECT_NEAR(result->timeOffsets[c], offsets[c], 5e-4);
    EXPECT_NEAR(result->cameras[c].intrinsics.focalX, 450.0, 1.0);
  }
  EXPECT_LT(misplacement(result->cameras, rig), 5e-3);
}

// Cameras that nothing synchronizes, as live ones: each looks when it likes, its clock is right.
// There are more instants than the starts are judged on.
TEST(WandCalibration, CamerasThatRunFreelyAreRefined) {
  const CameraRig rig = trueRig();
  const std::vector<double> phases{0.0, 0.021, -0.027, 0.009}; // of 1/15 s
  WandProblem problem = waveWand(rig, 2, 0.1, 300, phases);
  for (std::size_t c = 0; c < rig.size(); ++c) {
    for (MarkerObservation& view : problem.views[c]) {
      view.time += phases[c];
    }
  }
  problem.initialRig = movedCameras(rig, 0.1, 0.05, 0);
  const auto result = calibrateFromWand(problem);
  ASSERT_TRUE(result) << errorSentence(result.error());
  EXPECT_LT(misplacement(result->cameras, rig), 5e-3);
  problem.estimatesTimeOffsets = true;
  const auto offset = calibrateFromWand(problem);
  ASSERT_TRUE(offset) << errorSentence(offset.error());
  for (std::size_t c = 0; c < rig.size(); ++c) {
    EXPECT_NEAR(offset->timeOffsets[c], 0.0, 5e-4);
  }
}

// Far beyond what an adjustment that begins with equal clocks finds.
TEST(WandCalibration, ClocksThatAreFarOffAreFound) {
  const CameraRig rig = trueRig();
  const std::vector<double> offsets{0.0, 0.21, -0.34, 0.05}; // at 15 images per second
  WandProblem problem = waveWand(rig, 1, 0.1, 300, offsets);
  problem.initialRig = movedCameras(rig, 0.1, 0.05, 0);
  const auto roughly = searchTimeOffsets(problem);
  problem.estimatesTimeOffsets = true;
  const auto result = calibrateFromWand(problem);
  ASSERT_TRUE(result) << errorSentence(result.error());
  for (std::size_t c = 0; c < rig.size(); ++c) {
    EXPECT_NEAR(roughly[c], offsets[c], 0.5 / 15.0);
    EXPECT_NEAR(result->timeOffsets[c], offsets[c], 5e-4);
  }
}

// A ball at rest, or on a straight line, says nothing about clocks.
TEST(WandCalibration, ClocksStayWhereNothingIsClear) {
  const CameraRig rig = trueRig();
  const std::vector<double> none(rig.size(), 0.0);
  WandProblem problem = waveWand(
      rig, 1, 0.1, 100, none, [](double, std::size_t) { return Eigen::Vector3d(0.1, 0.2, 1.0); });
  problem.initialRig = movedCameras(rig, 0.1, 0.05, 0);
  EXPECT_EQ(searchTimeOffsets(problem), none);
  problem.views[1].clear();
  EXPECT_EQ(searchTimeOffsets(problem), none);
}

TEST(WandCalibration, TheSizeComesFromADistanceOrTheDiameter) {
  const CameraRig rig = trueRig();
  WandProblem problem = waveWand(rig, 1, 0.05);
  problem.initialRig = movedCameras(rig, 0.1, 0.05, 0);
  problem.scaleMethod = WandScale::Distance;
  problem.distance = {2.0, 8.0, 0.0};
  const auto mean = [](double time) { // of the places within a tenth of a second: three frames
    return ((wavedAt(time - 1.0 / 15.0, 0) + wavedAt(time, 0) + wavedAt(time + 1.0 / 15.0, 0)) /
            3.0)
        .eval();
  };
  problem.distance.meters = (mean(8.0) - mean(2.0)).norm();
  const auto measured = calibrateFromWand(problem);
  ASSERT_TRUE(measured) << errorSentence(measured.error());
  EXPECT_LT(misplacement(measured->cameras, rig), 3e-3);

  problem.scaleMethod =
      WandScale::Diameter; // exact radii here: only the noise of the places is left
  const auto sized = calibrateFromWand(problem);
  ASSERT_TRUE(sized) << errorSentence(sized.error());
  EXPECT_LT(misplacement(sized->cameras, rig), 3e-3);
  EXPECT_GT(sized->scaleSigma, 0.005); // 0.05 px of some 6
}

TEST(WandCalibration, FloorAndFallSayWhereUpIs) {
  const CameraRig rig = trueRig();
  // Rests at three places of the floor for two seconds each, then is waved, then falls.
  const Path path = [](double t, std::size_t) -> Eigen::Vector3d {
    if (t < 6.0) {
      const double angle = 2.0 * std::numbers::pi / 3.0 * std::floor(t / 2.0);
      return {0.5 * std::cos(angle), 0.5 * std::sin(angle), kWandRadius};
    }
    if (t < 18.0) {
      return wavedAt(t, 0);
    }
    const double fallen = t - 18.0;
    return {0.1, 0.1, std::max(kWandRadius, 1.6 - 0.5 * 9.81 * fallen * fallen)};
  };
  WandProblem problem = waveWand(rig, 1, 0.05, 300, {0.0, 0.0, 0.0, 0.0}, path);
  problem.initialRig = movedCameras(rig, 0.1, 0.05, 0);
  problem.scaleMethod = WandScale::Distance;
  problem.distance = {1.0, 3.0, std::sqrt(0.75)}; // of two corners of the triangle
  problem.floorTimes = {1.0, 3.0, 5.0};
  problem.freeFallSpan = std::array<double, 2>{18.01, 18.5};
  const auto result = calibrateFromWand(problem);
  ASSERT_TRUE(result) << errorSentence(result.error());
  EXPECT_TRUE(result->isFloorFound);
  for (std::size_t c = 0; c < rig.size(); ++c) {
    EXPECT_NEAR(result->cameras[c].center().z(), rig[c].center().z(), 5e-3);
  }
  ASSERT_TRUE(result->freeFall);
  EXPECT_NEAR(result->freeFall->gravity, 9.81, 0.15);

  problem.floorTimes.clear();
  const auto fallen = calibrateFromWand(problem);
  ASSERT_TRUE(fallen) << errorSentence(fallen.error());
  const auto heights = [](const CameraRig& cameras) {
    return cameras[0].center().z() - cameras[3].center().z();
  };
  EXPECT_NEAR(heights(fallen->cameras), heights(rig), 0.03);

  problem.floorTimes = {1.0, 1.2, 1.4}; // one and the same place
  EXPECT_EQ(calibrateFromWand(problem).error().field, "floor");
}

TEST(WandCalibration, SaysWhatIsMissing) {
  const CameraRig rig = trueRig();
  WandProblem problem = waveWand(rig, 2, 0.1, 60);
  problem.initialRig = movedCameras(rig, 0.1, 0.05, 0);
  problem.views[1].clear();
  EXPECT_EQ(calibrateFromWand(problem).error().field, "camera 2");
  problem = waveWand(rig, 1, 0.1, 60);
  problem.initialRig = rig;
  problem.stickLength = kWandLength; // but its second ball is never seen
  EXPECT_EQ(calibrateFromWand(problem).error().field, "stick");
  problem = waveWand(rig, 1, 0.0, 60, {0.0, 0.0, 0.0, 0.0},
                     [](double, std::size_t) { return Eigen::Vector3d(0.0, 0.0, 1.0); });
  problem.initialRig = rig;
  EXPECT_EQ(calibrateFromWand(problem).error().code, ErrorCode::Undetermined);
  EXPECT_EQ(calibrateFromWand(waveWand(rig, 2, 0.1, 60), [](const WandProgress&) { return false; })
                .error()
                .code,
            ErrorCode::Undetermined); // no initial rig at all
  problem = waveWand(rig, 2, 0.1, 60);
  problem.initialRig = rig;
  EXPECT_EQ(calibrateFromWand(problem, [](const WandProgress&) { return false; }).error().code,
            ErrorCode::Canceled);
}

} // namespace
} // namespace dewpoint::tests
