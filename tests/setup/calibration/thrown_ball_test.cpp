// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/calibration_record.h"
#include "core/setup/calibration/wand_refinement.h"
#include "tests/calibration/waved_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dewpoint::tests {
namespace {

constexpr double kFramesPerSecond = 30.0;
constexpr double kHold = 0.4;   ///< seconds in a hand
constexpr double kFlight = 0.7; ///< seconds in the air
constexpr double kHidden = 1.0; ///< pixels by which hands that hide a part of it shift its center
constexpr double kPixelNoise = 0.2;

const Eigen::Vector3d kLeftHand(-0.6, 0.05, 1.0);
const Eigen::Vector3d kRightHand(0.6, -0.05, 1.05);

/// A ball that is thrown from hand to hand.
Eigen::Vector3d thrownAt(double time) {
  const double phase = std::fmod(time, 2.0 * (kHold + kFlight));
  const bool isBack = phase >= kHold + kFlight;
  const Eigen::Vector3d& from = isBack ? kRightHand : kLeftHand;
  const Eigen::Vector3d& to = isBack ? kLeftHand : kRightHand;
  const double own = phase - (isBack ? kHold + kFlight : 0.0);
  if (own < kHold) { // swings down and up
    return from + Eigen::Vector3d(0.03 * std::sin(3.0 * time), 0.02 * std::cos(2.0 * time),
                                  -0.12 * std::sin(std::numbers::pi * own / kHold));
  }
  const double share = (own - kHold) / kFlight;
  Eigen::Vector3d position = from + share * (to - from);
  position.z() += 0.5 * 9.81 * kFlight * kFlight * share * (1.0 - share);
  return position;
}

bool isHidden(double time) {
  const double own = std::fmod(time, kHold + kFlight);
  return own < kHold + 0.15 || own > kHold + kFlight - 0.15;
}

/// Hands hide the ball from each camera in another way, which changes slowly: the errors of
/// neighboring images are alike, and those of all throws, too.
std::vector<std::vector<MarkerObservation>> thrown(const CameraRig& rig, std::uint32_t seed,
                                                   double seconds) {
  std::vector<std::vector<MarkerObservation>> views(rig.size());
  const RandomStream random(77, seed, 0, RandomPurpose::Noise);
  std::uint32_t number = 0;
  for (std::size_t c = 0; c < rig.size(); ++c) {
    const Projector projector(rig[c]);
    const auto own = random.normal4(9000 + static_cast<std::uint32_t>(c));
    for (int frame = 0; frame < static_cast<int>(seconds * kFramesPerSecond); ++frame) {
      const double time = frame / kFramesPerSecond;
      const auto pixel = projector.project(thrownAt(time));
      const auto draw = random.normal4(number++);
      if (!pixel || !simulated::inImage(rig[c], *pixel)) {
        continue;
      }
      const auto phase = static_cast<double>(c);
      const Eigen::Vector2d hidden(own[0] + 0.5 * std::sin(2.0 * time + phase),
                                   -1.0 + 0.5 * own[1] + 0.5 * std::cos(1.7 * time + phase));
      views[c].push_back({time, 0,
                          *pixel + (isHidden(time) ? kHidden : 0.0) * hidden +
                              kPixelNoise * Eigen::Vector2d(draw[0], draw[1]),
                          0.0, 0.3});
    }
  }
  return views;
}

/// A project with good cameras, off by a millimeter, as calibrated with a board or read from a
/// file.
Project goodProject(const CameraRig& truth, std::uint32_t seed, CalibrationOrigin origin,
                    std::optional<double> error) {
  Project project;
  for (const Camera& camera : simulated::moved(truth, 0.001, 0.0005, seed)) {
    ProjectCamera& one = project.cameras.emplace_back();
    one.camera = camera;
    one.calibrationRecord.pose = recordOfPose(camera, origin, error);
  }
  Target ball;
  ball.name = "ball";
  ball.radius = 0.0;
  project.targets.push_back(ball);
  return project;
}

double worstPosition(const CameraRig& found, const CameraRig& truth) {
  const Similarity change = fitRigSimilarity(found, truth, true);
  double worst = 0.0;
  for (std::size_t c = 0; c < truth.size(); ++c) {
    worst = std::max(worst, (change * found[c].center() - truth[c].center()).norm());
  }
  return worst;
}

/// Five seconds move good cameras by centimeters; so they are not applied, and it is said why.
TEST(ThrownBall, HalfHiddenByHandsMakesNothingWorse) {
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE(seed);
    const CameraRig truth = simulated::rig(seed, 2 + static_cast<int>(seed % 4));
    const bool isFromFile = seed % 2 == 1; // then no error is recorded
    const Project project = isFromFile
                                ? goodProject(truth, seed, CalibrationOrigin::File, std::nullopt)
                                : goodProject(truth, seed, CalibrationOrigin::Board, 0.0015);
    const auto refinement = refineFromViews(project, thrown(truth, seed, 5.0), {});
    ASSERT_TRUE(refinement) << errorSentence(refinement.error());
    EXPECT_GT(worstPosition(refinement->result.cameras, truth),
              3.0 * worstPosition(refinement->camerasBefore, truth)); // so it must not be applied
    EXPECT_TRUE(isUnnecessary(*refinement) || areOldCamerasMoreAccurate(*refinement));
    EXPECT_TRUE(isDoubtful(*refinement));
    ASSERT_FALSE(refinement->gaps.empty());
    EXPECT_EQ(refinement->gaps[0].missingMotion, MissingMotion::OffThePlane)
        << motionGapText(refinement->gaps[0], truth);
  }
}

/// A camera that was moved is refined although it is recorded as well known.
TEST(ThrownBall, AMovedCameraIsStillCorrected) {
  const std::uint32_t seed = 2;
  const CameraRig truth = simulated::rig(seed);
  Project project = goodProject(truth, seed, CalibrationOrigin::Board, 0.0015);
  ProjectCamera& moved = project.cameras[1];
  moved.camera = simulated::moved(truth, 0.03, 0.03, seed + 10)[1];
  moved.calibrationRecord.pose = recordOfPose(moved.camera, CalibrationOrigin::Board, 0.0015);
  const auto refinement = refineFromViews(project, thrown(truth, seed, 5.0), {});
  ASSERT_TRUE(refinement) << errorSentence(refinement.error());
  EXPECT_FALSE(isUnnecessary(*refinement));
  EXPECT_FALSE(areOldCamerasMoreAccurate(*refinement));
}

/// A wave through the volume is better than what was known, and is used.
TEST(ThrownBall, AGoodWaveIsNotHeldBack) {
  const std::uint32_t seed = 3;
  const CameraRig truth = simulated::rig(seed);
  const Project project = goodProject(truth, seed, CalibrationOrigin::File, std::nullopt);
  auto views = simulated::wave(truth, seed, 0.2, 450).views;
  for (auto& camera : views) {
    std::erase_if(camera, [](const MarkerObservation& view) { return view.ball != 0; });
  }
  const auto refinement = refineFromViews(project, views, {});
  ASSERT_TRUE(refinement) << errorSentence(refinement.error());
  EXPECT_TRUE(refinement->gaps.empty());
  EXPECT_FALSE(areOldCamerasMoreAccurate(*refinement));
  EXPECT_LT(worstPosition(refinement->result.cameras, truth), 0.002);
}

} // namespace
} // namespace dewpoint::tests
