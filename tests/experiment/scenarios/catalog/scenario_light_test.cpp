// SPDX-License-Identifier: GPL-3.0-or-later
// Scenarios about light that is not that of one white lamp, and about exposures that are not fixed:
// S20.
#include "core/experiment/scenarios/catalog/recipes.h"
#include "core/experiment/scenarios/draft/grade_model.h"
#include "core/simulation/room/light.h"
#include "tests/experiment/scenarios/scenario_drafts.h"
#include "tests/experiment/scenarios/scenario_images.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace dewpoint::tests {
namespace {

using experiment::scenarios::kLampDistance;

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

/// How much stronger a light (BGR) is in red than in blue.
double rednessOf(const Eigen::Vector3d& color) {
  return color[2] / color[0];
}

/// The same of an image's mean.
double rednessOf(const cv::Mat& image) {
  const cv::Scalar mean = cv::mean(image);
  return mean[2] / mean[0];
}

TEST(ScenarioIllumination, ASecondLampIsABulbOrTheSky) {
  const auto rednessAt = [](double kelvin) {
    return rednessOf(simulation::colorTemperatureGain(kelvin));
  };
  int warm = 0;
  int cold = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const ScenarioDraft draft =
        draftOf(experiment::scenarios::lampScenarios(), "S20-second-lamp", seed);
    const SensingFaults faults = faultsOf(draft);
    EXPECT_EQ(faults.illumination.roomGain, 0.8F);
    ASSERT_EQ(faults.illumination.additionalLamps.size(), 1U);
    const simulation::AdditionalLamp& lamp = faults.illumination.additionalLamps.front();
    EXPECT_GE(lamp.color[1], 0.3F); // in green all color temperatures have their strength
    EXPECT_LE(lamp.color[1], 0.5F);
    const double red = rednessOf(Eigen::Vector3d(lamp.color.cast<double>()));
    const bool isBulb = red >= 0.999 * rednessAt(3500.0) && red <= 1.001 * rednessAt(2700.0);
    const bool isSky = red >= 0.999 * rednessAt(10000.0) && red <= 1.001 * rednessAt(8000.0);
    EXPECT_TRUE(isBulb || isSky) << red;
    warm += isBulb ? 1 : 0;
    cold += isSky ? 1 : 0;
    const Eigen::Vector3d way = lamp.position.cast<double>() - centerAt(draft, 0);
    EXPECT_NEAR(way.head<2>().norm(), kLampDistance, 1e-5);
    EXPECT_GT(way.z(), 0.29);
    EXPECT_LT(way.z(), 1.51);
  }
  EXPECT_GT(warm, 0);
  EXPECT_GT(cold, 0);
}

TEST(ScenarioIllumination, ASecondLampColorsTheImages) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const ScenarioDraft draft =
        draftOf(experiment::scenarios::lampScenarios(), "S20-second-lamp", seed);
    const ScenarioDraft lit = withFaults(draft);
    const bool isWarm = lit.stage.illumination.additionalLamps.at(0).color[2] >
                        lit.stage.illumination.additionalLamps.at(0).color[0];
    for (const std::size_t camera : {0U, 1U}) {
      const double change =
          rednessOf(imageOf(lit, camera, 0)) / rednessOf(imageOf(draft, camera, 0));
      // Half of the surfaces face the lamp, by half on average, which adds a tenth to their light
      // in the weaker color and a fifth in the stronger.
      EXPECT_GT(isWarm ? change : 1.0 / change, 1.02);
    }
  }
}

/// Mean red of the target's disc, gray levels.
double discLevel(const ScenarioDraft& draft, const cv::Mat& image, std::size_t camera,
                 std::int64_t frame) {
  const ImageDisc disc = discOf(draft.rig[camera], centerAt(draft, frame),
                                draft.stage.bodies.at(draft.targets.front()).radius);
  double sum = 0.0;
  const int count = countIn(image, disc, [&](const cv::Vec3b& pixel) {
    sum += pixel[2];
    return true;
  });
  return sum / std::max(1, count);
}

TEST(ScenarioIllumination, AShadowPassesOverTheBall) {
  for (const std::uint64_t seed : {1U, 2U}) {
    const ScenarioDraft draft = draftOf(experiment::scenarios::lampScenarios(), "S20-shadow", seed);
    const auto shadow = faultsOf(draft).illumination.shadow;
    ASSERT_TRUE(shadow);
    EXPECT_GE(shadow->blockedFraction, 0.8F);
    EXPECT_LE(shadow->blockedFraction, 1.0F);
    EXPECT_GE(shadow->halfWidth, 0.05F);
    EXPECT_LE(shadow->halfWidth, 0.2F);
    EXPECT_GE(shadow->speed, 0.1);
    EXPECT_LE(shadow->speed, 0.4);
    // How far the middle of the shadow is from the ball's center, meters.
    const auto aside = [&](std::int64_t frame) {
      const double middle = shadow->initialPosition + shadow->speed * draft.timeOf(frame);
      return std::abs(shadow->direction.cast<double>().dot(centerAt(draft, frame)) - middle);
    };
    std::int64_t darkest = 0;
    for (std::int64_t frame = 0; frame < draft.frameCount; ++frame) {
      darkest = aside(frame) < aside(darkest) ? frame : darkest;
    }
    EXPECT_LT(aside(darkest), 0.012) << "half a frame at 0.7 m/s";
    // Of the light on the discs 43 % (camera 1) and 30 % (camera 2) come from the lamp, by
    // Lambert's law 60 and 85 degrees off the line of sight; the narrowest and lightest shadow
    // takes 0.78 of that.
    const ScenarioRun run = scenarioRun("S20-shadow", seed);
    for (const std::size_t camera : {0U, 1U}) {
      const cv::Mat image = run.frames(darkest)->frames.at(camera)->image;
      const double light = discLevel(draft, imageOf(draft, camera, darkest), camera, darkest);
      EXPECT_LT(discLevel(draft, image, camera, darkest), 0.85 * light) << seed;
    }
  }
}

TEST(ScenarioIllumination, ExposureJumps) {
  const ScenarioRun run = scenarioRun("S20-exposure-steps");
  std::vector<double> means;
  for (std::int64_t frame = 0; frame < run.frameCount; frame += 9) {
    means.push_back(cv::mean(run.frames(frame)->frames[0]->image)[1]);
  }
  EXPECT_LT(std::ranges::min(means), 0.95 * std::ranges::max(means));
  EXPECT_NEAR(means[0], means[2], 0.01 * means[0]) << "no step before frame 20";
}

} // namespace
} // namespace dewpoint::tests
