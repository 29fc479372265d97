// SPDX-License-Identifier: GPL-3.0-or-later
// What a grade draws, against the numbers of the table in docs/scenarios.md, written down here once
// more: comparing it with the model that it is drawn from would hold for any numbers.
#include "core/experiment/scenarios/draft/grade_model.h"
#include "core/simulation/room/light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace dewpoint::tests {
namespace {

using namespace dewpoint::experiment::scenarios;

constexpr std::size_t kCameras = 3;

/// A number of a camera or of a run, and between which it is drawn in both grades.
template <class Owner> struct TableRow {
  const char* name;
  Range room;
  Range wild;
  double (*of)(const Owner&);
};

const std::vector<TableRow<CameraFaults>>& cameraRows() {
  using Of = CameraFaults;
  static const std::vector<TableRow<Of>> kRows{
      {"blur, px", {0.5, 2.0}, {0.7, 3.0}, [](const Of& c) { return c.sensor.psfSigmaPx; }},
      {"electrons",
       {1e3, 6e3},
       {300, 3e3},
       [](const Of& c) { return c.sensor.noise.fullWellElectrons; }},
      {"read noise",
       {2, 6},
       {3, 10},
       [](const Of& c) { return c.sensor.noise.readNoiseElectrons; }},
      {"tone curve", {0.88, 1.12}, {0.75, 1.3}, [](const Of& c) { return c.sensor.contrast; }},
      {"sharpening", {0.2, 1}, {0.2, 2}, [](const Of& c) { return c.sensor.sharpening.amount; }},
      {"its sigma, px",
       {0.8, 1.5},
       {0.8, 2.0},
       [](const Of& c) { return c.sensor.sharpening.sigmaPx; }},
      {"JPEG", {40, 90}, {25, 80}, [](const Of& c) { return double(c.sensor.jpegQuality); }},
      {"corners", {0.1, 0.35}, {0.1, 0.5}, [](const Of& c) { return c.unevenLight.vignette; }},
      {"right",
       {-0.12, 0.12},
       {-0.25, 0.25},
       [](const Of& c) { return c.unevenLight.lightGainTowardRight; }},
      {"down",
       {-0.12, 0.12},
       {-0.25, 0.25},
       [](const Of& c) { return c.unevenLight.lightGainTowardBottom; }},
      {"exposure, s",
       {0.010, 0.033},
       {0.010, 0.033},
       [](const Of& c) { return c.sensor.shutter.exposureSeconds; }},
      {"readout, s",
       {0.015, 0.030},
       {0.015, 0.033},
       [](const Of& c) { return c.sensor.shutter.readoutSeconds; }},
      {"settles at, stops",
       {-0.3, 0.3},
       {-0.7, 0.7},
       [](const Of& c) { return c.automaticGain->exposureOffsetStops; }},
      {"off at frame 0, stops",
       {-0.3, 0.3},
       {-1.0, 1.0},
       [](const Of& c) { return c.automaticGain->initialExposureErrorStops; }},
      {"blue, stops",
       {-0.12, 0.12},
       {-0.25, 0.25},
       [](const Of& c) { return c.automaticGain->whiteBalanceStops[0]; }},
      {"red, stops",
       {-0.12, 0.12},
       {-0.25, 0.25},
       [](const Of& c) { return c.automaticGain->whiteBalanceStops[1]; }},
      {"hunting, stops",
       {0, 0.2},
       {0, 0.5},
       [](const Of& c) { return c.automaticGain->huntingAmplitudeStops; }},
      {"its period, s",
       {2, 6},
       {1, 5},
       [](const Of& c) { return c.automaticGain->huntingPeriodSeconds; }},
      {"speed of the control",
       {0.05, 0.25},
       {0.05, 0.3},
       [](const Of& c) { return c.automaticGain->exposureLoop.correctedFractionPerFrame; }},
      {"its delay, frames",
       {1, 4},
       {1, 4},
       [](const Of& c) { return double(c.automaticGain->exposureLoop.lagInFrames); }},
      {"delay, frames",
       {0, 0.5},
       {0, 0.5},
       [](const Of& c) { return 30.0 * c.timing.delaySeconds; }},
      {"jitter, s", {0, 0.003}, {0, 0.006}, [](const Of& c) { return c.timing.jitterSeconds; }},
      {"dropped", {0, 0.02}, {0, 0.08}, [](const Of& c) { return c.timing.droppedFrameShare; }},
      {"doubled", {0, 0.02}, {0, 0.08}, [](const Of& c) { return c.timing.repeatedFrameShare; }},
      {"warming up, rad",
       {0, 0.001},
       {0, 0.003},
       [](const Of& c) { return c.sensor.drift.rotation.norm(); }},
      {"its time constant, s",
       {2, 20},
       {1, 10},
       [](const Of& c) { return c.sensor.drift.settleSeconds; }},
  };
  return kRows;
}

const std::vector<TableRow<SensingFaults>>& runRows() {
  using Of = SensingFaults;
  static const std::vector<TableRow<Of>> kRows{
      {"white lamp",
       {0, 0.8},
       {0, 1.2},
       [](const Of& run) { return double(run.illumination.additionalLamps.at(0).color[2]); }},
      {"colored lamp, in green",
       {0, 0.2},
       {0, 0.4},
       [](const Of& run) { return double(run.illumination.additionalLamps.at(1).color[1]); }},
      {"flicker",
       {0, 0.35},
       {0, 0.9},
       [](const Of& run) { return run.cameras.front().sensor.flicker.modulationDepth; }},
      {"shadow, depth",
       {0.3, 0.9},
       {0.5, 1.0},
       [](const Of& run) { return double(run.illumination.shadow->blockedFraction); }},
      {"shadow, half width, m",
       {0.05, 0.3},
       {0.05, 0.4},
       [](const Of& run) { return double(run.illumination.shadow->halfWidth); }},
      {"shadow, m/s",
       {0.1, 0.5},
       {0.1, 1.0},
       [](const Of& run) { return run.illumination.shadow->speed; }},
  };
  return kRows;
}

/// The faults of 200 runs.
std::vector<SensingFaults> drawnRuns(Grade grade) {
  FaultContext context;
  context.cameraCount = kCameras;
  std::vector<SensingFaults> runs;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    RandomDraws draws(seed, "grade test");
    runs.push_back(randomFaults(gradeModel(grade), context, draws));
    EXPECT_EQ(runs.back().cameras.size(), kCameras);
  }
  return runs;
}

/// All values are within the range, and some in the tenths at both of its ends: of 200 even draws
/// none is there in one case of 10^9.
void expectDrawn(const char* name, const Range& range, const std::vector<double>& values) {
  constexpr double kRounding = 1e-6; // some are floats
  const auto [low, high] = std::ranges::minmax_element(values);
  const double tenth = 0.1 * (range.high - range.low);
  EXPECT_GE(*low, range.low - kRounding) << name;
  EXPECT_LT(*low, range.low + tenth) << name;
  EXPECT_GT(*high, range.high - tenth) << name;
  EXPECT_LE(*high, range.high + kRounding) << name;
}

TEST(GradeTable, CamerasAreDrawnFromAllOfIt) {
  for (const Grade grade : {Grade::Room, Grade::Wild}) {
    const auto runs = drawnRuns(grade);
    for (const auto& row : cameraRows()) {
      std::vector<double> values;
      for (const SensingFaults& run : runs) {
        for (const CameraFaults& camera : run.cameras) {
          values.push_back(row.of(camera));
        }
      }
      expectDrawn(row.name, grade == Grade::Room ? row.room : row.wild, values);
    }
  }
}

TEST(GradeTable, RunsAreDrawnFromAllOfIt) {
  // The color of a lamp: how much stronger it is in red than in blue.
  const auto redness = [](double kelvin) {
    const Eigen::Vector3d gain = simulation::colorTemperatureGain(kelvin);
    return gain[2] / gain[0];
  };
  for (const Grade grade : {Grade::Room, Grade::Wild}) {
    const auto runs = drawnRuns(grade);
    for (const auto& row : runRows()) {
      std::vector<double> values;
      for (const SensingFaults& run : runs) {
        values.push_back(row.of(run));
      }
      expectDrawn(row.name, grade == Grade::Room ? row.room : row.wild, values);
    }
    for (const SensingFaults& run : runs) {
      EXPECT_FALSE(run.illumination.isDefault());
      const simulation::AdditionalLamp& colored = run.illumination.additionalLamps.at(1);
      const double red = colored.color[2] / colored.color[0];
      EXPECT_LT(red, 1.001 * redness(grade == Grade::Room ? 2700.0 : 2200.0));
      EXPECT_GT(red, 0.999 * redness(grade == Grade::Room ? 9000.0 : 12000.0));
      const double frequency = run.cameras.front().sensor.flicker.frequencyHz;
      EXPECT_TRUE(frequency == 100.0 || frequency == 120.0);
    }
  }
}

TEST(GradeTable, CalibrationErrorsAreThoseOfTheTable) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  for (const auto& [grade, times] : {std::pair(Grade::Room, 1.0), std::pair(Grade::Wild, 2.0)}) {
    const CalibrationError error = drawnRuns(grade).front().cameras.front().calibration;
    EXPECT_NEAR(error.relativeFocalLength, times * 0.005, 1e-12);
    EXPECT_NEAR(error.positionMeters, times * 0.002, 1e-12);
    EXPECT_NEAR(error.rotationRadians, times * 0.2 * kDegree, 1e-12);
    EXPECT_NEAR(error.radialDistortion, times * 0.01, 1e-12);
  }
}

TEST(GradeTable, TheControlIsStable) {
  for (const Grade grade : {Grade::Room, Grade::Wild}) {
    for (const SensingFaults& run : drawnRuns(grade)) {
      for (const CameraFaults& camera : run.cameras) {
        const simulation::ControlLoop& loop = camera.automaticGain->exposureLoop;
        EXPECT_LT(loop.correctedFractionPerFrame,
                  2.0 * std::sin(std::numbers::pi / (4.0 * loop.lagInFrames + 2.0)));
      }
    }
  }
}

} // namespace
} // namespace dewpoint::tests
