// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/quality/fault_finder.h"
#include "core/calibration/wand/wand_bundle.h"
#include "core/geometry/projector.h"
#include "tests/calibration/waved_rig.h"

#include <gtest/gtest.h>

#include <functional>

namespace dewpoint::tests {
namespace {

using namespace simulated;

constexpr int kFrames = 300;

double noiseOf(std::uint32_t seed) {
  return 0.1 + 0.1 * (seed % 3);
}

/// The question that a waved stick is, before anything is wrong with it.
WandProblem clean(std::uint32_t seed, int cameras = 4) {
  const CameraRig truth = rig(seed, cameras);
  WandProblem problem = wave(truth, seed, noiseOf(seed), kFrames);
  problem.initialRig = moved(truth, 0.1, 0.05, seed);
  return problem;
}

FaultReport find(const WandProblem& problem) {
  const auto bundle = makeWandBundle(problem);
  EXPECT_TRUE(bundle) << errorSentence(bundle.error());
  FaultSearchInput question;
  question.problem = *bundle;
  return findFaults(question);
}

std::string told(const FaultReport& report) {
  std::string text;
  for (const DetectedFault& fault : report.faults) {
    text += std::string(faultName(fault.fault)) + " gain " +
            std::to_string(fault.logLikelihoodGain) + ": " + fault.sentence + "\n";
  }
  return text + "sigma " + std::to_string(report.sigmaPx);
}

/// Exactly this fault is named, of these cameras.
void expectOnly(const FaultReport& report, CalibrationFault fault,
                const std::vector<std::size_t>& cameras) {
  ASSERT_EQ(report.faults.size(), 1U) << told(report);
  EXPECT_EQ(report.faults[0].fault, fault) << told(report);
  EXPECT_EQ(report.faults[0].cameras, cameras) << told(report);
  EXPECT_FALSE(report.faults[0].sentence.empty());
}

using Seeds = std::vector<std::uint32_t>;
const Seeds kSeeds{1, 2};

TEST(FaultFinder, CleanWavesRaiseNoAlarm) {
  for (std::uint32_t seed = 0; seed < 3; ++seed) {
    const auto report = find(clean(seed, 3 + int(seed % 3)));
    EXPECT_TRUE(report.faults.empty()) << seed << " " << told(report);
    EXPECT_NEAR(report.sigmaPx / noiseOf(seed), 1.0, 0.4);
  }
}

/// The figure of the documentation; some minutes.
TEST(FaultFinder, DISABLED_FiftyCleanWavesRaiseNoAlarm) {
  for (std::uint32_t seed = 100; seed < 150; ++seed) {
    const auto report = find(clean(seed, 3 + int(seed % 3)));
    EXPECT_TRUE(report.faults.empty()) << seed << " " << told(report);
    std::printf("%u: sigma %.3f of %.1f, %zu named\n", seed, report.sigmaPx, noiseOf(seed),
                report.faults.size());
    std::fflush(stdout);
  }
}

TEST(FaultFinder, SwappedVideosAreNamed) {
  for (const auto seed : kSeeds) {
    SCOPED_TRACE(seed);
    WandProblem problem = clean(seed);
    const std::size_t other = 1 + seed % 3;
    std::swap(problem.views[0], problem.views[other]);
    expectOnly(find(problem), CalibrationFault::CamerasSwapped, {0, other});
  }
}

TEST(FaultFinder, ALateCameraIsNamed) {
  for (const auto seed : kSeeds) {
    SCOPED_TRACE(seed);
    const CameraRig truth = rig(seed);
    const int late = seed % 2 == 0 ? 10 : -23;
    WandProblem problem = wave(truth, seed, noiseOf(seed), kFrames, {0.0, 0.0, late / kRate, 0.0});
    problem.initialRig = moved(truth, 0.1, 0.05, seed);
    const auto report = find(problem);
    expectOnly(report, CalibrationFault::CameraDelayed, {2});
    if (!report.faults.empty()) {
      EXPECT_EQ(report.faults[0].value, late);
    }
  }
}

TEST(FaultFinder, ACameraThatMovedIsNamed) {
  for (const auto seed : kSeeds) {
    SCOPED_TRACE(seed);
    const CameraRig truth = rig(seed);
    CameraRig later = truth;
    later[1] = moved(truth, 0.03, 0.02, seed + 50)[1];
    WandProblem problem = wave(truth, seed, noiseOf(seed), kFrames);
    const WandProblem after = wave(later, seed, noiseOf(seed), kFrames);
    std::erase_if(problem.views[1],
                  [](const MarkerObservation& view) { return view.time >= 10.0; });
    for (const MarkerObservation& view : after.views[1]) {
      if (view.time >= 10.0) {
        problem.views[1].push_back(view);
      }
    }
    problem.initialRig = moved(truth, 0.1, 0.05, seed);
    const auto report = find(problem);
    expectOnly(report, CalibrationFault::CameraMoved, {1});
    if (!report.faults.empty()) {
      EXPECT_NEAR(report.faults[0].value, 10.0, 2.0); // splits are tried by tenths of 20 s
    }
  }
}

TEST(FaultFinder, AFlippedVideoIsNamed) {
  for (const auto seed : kSeeds) {
    SCOPED_TRACE(seed);
    WandProblem problem = clean(seed);
    for (MarkerObservation& view : problem.views[3]) {
      view.pixel.x() = seed == 2 ? view.pixel.x() : 639.0 - view.pixel.x();
      view.pixel.y() = seed == 1 ? view.pixel.y() : 479.0 - view.pixel.y();
    }
    expectOnly(find(problem), CalibrationFault::VideoFlipped, {3});
  }
}

TEST(FaultFinder, AChangedZoomIsNamed) {
  for (const auto seed : kSeeds) {
    SCOPED_TRACE(seed);
    const double ratio = seed % 2 == 0 ? 1.12 : 0.8;
    CameraRig truth = rig(seed);
    truth[0].intrinsics.focalX *= ratio;
    truth[0].intrinsics.focalY *= ratio;
    WandProblem problem = wave(truth, seed, noiseOf(seed), kFrames);
    problem.initialRig = moved(rig(seed), 0.1, 0.05, seed);
    const auto report = find(problem);
    expectOnly(report, CalibrationFault::ZoomChanged, {0});
    if (!report.faults.empty()) {
      EXPECT_NEAR(report.faults[0].value / ratio, 1.0, 0.03);
    }
  }
}

TEST(FaultFinder, LensDataOfAnotherResolutionAreNamed) {
  for (const auto seed : kSeeds) {
    SCOPED_TRACE(seed);
    WandProblem problem = clean(seed);
    const double ratio = seed % 2 == 0 ? 2.0 : 2.0 / 3.0;
    for (MarkerObservation& view : problem.views[2]) {
      view.pixel = (view.pixel.array() + 0.5) * ratio - 0.5;
    }
    expectOnly(find(problem), CalibrationFault::WrongResolution, {2});
  }
  FaultSearchInput question;
  question.problem = *makeWandBundle(clean(1));
  question.imageSizes = {{640, 480}, {1280, 960}, {640, 480}, {640, 480}};
  expectOnly(findFaults(question), CalibrationFault::WrongResolution, {1});
}

TEST(FaultFinder, HalfAPixelIsNamed) {
  for (const auto seed : kSeeds) {
    SCOPED_TRACE(seed);
    const CameraRig truth = rig(seed);
    WandProblem problem = wave(truth, seed, 0.1, kFrames);
    problem.initialRig = moved(truth, 0.1, 0.05, seed);
    for (auto& views : problem.views) {
      for (MarkerObservation& view : views) {
        view.pixel.array() += seed % 2 == 0 ? 0.5 : -0.5;
      }
    }
    expectOnly(find(problem), CalibrationFault::HalfPixel, {});
  }
}

// The poses of two cameras explain shifted principal points just as well.
TEST(FaultFinder, TwoCamerasNeverNameHalfAPixel) {
  for (const auto seed : kSeeds) {
    SCOPED_TRACE(seed);
    for (const double shift : {0.0, 0.5, -0.5}) {
      WandProblem problem = clean(seed, 2);
      for (auto& views : problem.views) {
        for (MarkerObservation& view : views) {
          view.pixel.array() += shift;
        }
      }
      for (const DetectedFault& fault : find(problem).faults) {
        EXPECT_NE(fault.fault, CalibrationFault::HalfPixel) << shift;
      }
    }
  }
}

TEST(FaultFinder, MixedUnitsAreNamed) {
  for (const auto seed : kSeeds) {
    SCOPED_TRACE(seed);
    WandProblem problem = clean(seed);
    problem.stickLength = 1000.0 * kStick;
    expectOnly(find(problem), CalibrationFault::WrongUnitMillimeters, {});
    problem.stickLength = kStick / 0.0254;
    expectOnly(find(problem), CalibrationFault::WrongUnitInches, {});
    problem.stickLength = kStick;
    for (Camera& camera : problem.initialRig) {
      camera.cameraFromWorld.translation() *= 1000.0;
    }
    expectOnly(find(problem), CalibrationFault::WrongUnitMillimeters, {});
  }
}

/// A chessboard of 9 x 6 corners shown in many places, and once on the floor.
FaultSearchInput shown(std::uint32_t seed, bool floor, double noise = 0.1) {
  const CameraRig truth = rig(seed);
  FaultSearchInput question;
  question.board = BoardDescription{};
  question.board->squareSize = floor ? 0.15 : 0.06;
  BundleBody body{"board", BundleBody::Kind::Board};
  for (int id = 0; id < question.board->cornerCount(); ++id) {
    body.points.push_back(question.board->corner(id));
  }
  const RandomStream random(22, seed, 0, RandomPurpose::Noise);
  std::uint32_t count = 0;
  const int positions = floor ? 1 : 25;
  for (int k = 0; k < positions; ++k) {
    BundleState state;
    state.time = k;
    state.isFixed = floor;
    state.isPositionKnown = !floor;
    state.worldFromBoard = worldFromFlatBoard();
    Eigen::Isometry3d real = state.worldFromBoard; // lies flat, then is tilted and carried about
    if (!floor) {
      const auto draw = random.normal4(std::uint32_t(k), 7);
      real.prerotate(Eigen::AngleAxisd(0.3, Eigen::Vector3d(draw[0], draw[1], 0.0).normalized()));
      real.pretranslate(Eigen::Vector3d(0.5 * draw[2], 0.5 * draw[3], 0.7 + 0.03 * k));
    }
    for (std::size_t c = 0; c < truth.size(); ++c) {
      if ((real.inverse() * truth[c].center()).z() > 0.0) {
        continue; // nothing is printed on its back
      }
      for (std::size_t id = 0; id < body.points.size(); ++id) {
        const auto pixel = Projector(truth[c]).project(real * body.points[id]);
        const auto draw = random.normal4(count++);
        if (pixel && inImage(truth[c], *pixel)) {
          question.problem.observations.push_back(
              {c, std::size_t(k), id, *pixel + noise * Eigen::Vector2d(draw[0], draw[1]), noise});
        }
      }
    }
    question.problem.states.push_back(state);
  }
  question.problem.bodies.push_back(body);
  for (const Camera& camera : moved(truth, 0.1, 0.05, seed)) {
    question.problem.cameras.push_back({.camera = camera});
  }
  return question;
}

TEST(FaultFinder, CleanBoardsRaiseNoAlarm) {
  for (const auto seed : kSeeds) {
    for (const bool floor : {false, true}) {
      const auto report = findFaults(shown(seed, floor));
      EXPECT_TRUE(report.faults.empty()) << seed << " " << told(report);
    }
  }
}

TEST(FaultFinder, MirroredBoardsAndFloorsAreNamed) {
  for (const auto seed : kSeeds) {
    for (const bool floor : {false, true}) {
      SCOPED_TRACE(seed);
      FaultSearchInput question = shown(seed, floor);
      for (Eigen::Vector3d& point : question.problem.bodies[0].points) {
        (seed % 2 == 0 ? point.x() : point.y()) *= -1.0;
      }
      expectOnly(findFaults(question), CalibrationFault::MirroredBoard, {});
    }
  }
}

TEST(FaultFinder, WrongSquaresAreNamed) {
  for (const auto seed : kSeeds) {
    SCOPED_TRACE(seed);
    FaultSearchInput larger = shown(seed, false);
    for (Eigen::Vector3d& point : larger.problem.bodies[0].points) {
      point *= 1.25;
    }
    expectOnly(findFaults(larger), CalibrationFault::WrongSquareSize, {});

    FaultSearchInput fewer = shown(seed, false); // 54 corners, taken for rows of 8
    fewer.board->columns = seed % 2 == 0 ? 8 : 10;
    for (std::size_t id = 0; id < 54; ++id) {
      fewer.problem.bodies[0].points[id] = fewer.board->corner(int(id));
    }
    const auto report = findFaults(fewer);
    expectOnly(report, CalibrationFault::WrongSquareCount, {});
    if (!report.faults.empty()) {
      EXPECT_EQ(report.faults[0].value, 9.0);
    }
  }
}

} // namespace
} // namespace dewpoint::tests
