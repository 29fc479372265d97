// SPDX-License-Identifier: GPL-3.0-or-later
// Scenarios whose target is no ball, S21, or whose color is learned from a click, S22.
#include "core/experiment/scenarios/draft/target_truth.h"
#include "core/simulation/body/part_shapes.h"
#include "tests/experiment/scenarios/scenario_images.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace dewpoint::tests {
namespace {

TEST(TargetTruth, OfABallItIsItsCenterAndRadius) {
  simulation::StageBody ball;
  ball.path = [](double time) -> Eigen::Vector3d { return {time, 0.0, 0.1}; };
  ball.radius = 0.05;
  const auto truth = experiment::scenarios::targetTruth(ball, 2.0);
  EXPECT_EQ(truth.position, Eigen::Vector3d(2.0, 0.0, 0.1));
  EXPECT_EQ(truth.extent.radius, 0.05);
  EXPECT_EQ(truth.extent.halfAxes, Eigen::Vector3d::Constant(0.05));
  // Parts that are not marked, such as the hand around it, change nothing.
  ball.parts = [](double) {
    return std::vector{simulation::ballPart(0.2, Eigen::Vector3f::Zero())};
  };
  EXPECT_EQ(experiment::scenarios::targetTruth(ball, 2.0).extent.radius, 0.05);
}

TEST(TargetTruth, OfAConeItIsItsCentroid) {
  simulation::StageBody body;
  body.path = [](double) -> Eigen::Vector3d { return {1.0, 0.0, 0.0}; };
  body.parts = [](double) {
    simulation::MovingPart cone = simulation::frustumBetween({0.0, 0.0, 0.0}, 0.1, {0.0, 0.0, 0.4},
                                                             0.0, Eigen::Vector3f::Zero());
    cone.belongsToTarget = true;
    return std::vector{cone};
  };
  const auto truth = experiment::scenarios::targetTruth(body, 0.0);
  EXPECT_LT((truth.position - Eigen::Vector3d(1.0, 0.0, 0.1)).norm(), 1e-6);
  // Volume pi / 3 x 0.01 x 0.4; of a ball 4/3 pi r³: r³ = 0.001. Variances 3/80 x 0.16 = 0.006 and
  // 3/20 x 0.01 = 0.0015, times 5.
  EXPECT_NEAR(truth.extent.radius, 0.1, 1e-6);
  EXPECT_NEAR(truth.extent.halfAxes[0], std::sqrt(0.03), 1e-6);
  EXPECT_NEAR(truth.extent.halfAxes[2], std::sqrt(0.0075), 1e-6);
}

TEST(ScenarioShapes, TheColorIsAroundTheTruth) {
  for (const char* name :
       {"S21-cap", "S21-hand", "S21-sleeve", "S21-cone", "S21-stick", "S21-mouse", "S21-shirt"}) {
    const ScenarioRun run = scenarioRun(name);
    ASSERT_EQ(run.extents.size(), run.truth.samples.size()) << name;
    EXPECT_EQ(run.targets.front().radius, 0.0) << "methods are not told";
    const std::int64_t frame = 100;
    const TargetExtent& extent = run.extents.at(static_cast<std::size_t>(frame));
    // Of all shapes of one volume the ball has the least second moments.
    EXPECT_GE(extent.halfAxes[0], 0.999 * extent.radius) << name;
    EXPECT_GE(extent.halfAxes[0], extent.halfAxes[1]) << name;
    EXPECT_GE(extent.halfAxes[1], extent.halfAxes[2]) << name;
    const FrameSetPtr set = run.frames(frame);
    for (std::size_t camera = 0; camera < run.trueRig.size(); ++camera) {
      // A stick reaches sqrt(5/3) = 0.77 of the half axis of its ellipsoid, a fist 1.3; as much
      // again for what is nearer to the camera.
      const ImageDisc around =
          discOf(run.trueRig[camera], truthAt(run, frame).front(), 1.6 * extent.halfAxes[0]);
      const ImageDisc all{around.center, 1e6};
      const cv::Mat& image = set->frames[camera]->image;
      const double inside = matchingShare(image, run.targets[0].color, around) * around.area();
      const double total = matchingShare(image, run.targets[0].color, all) * all.area();
      EXPECT_GT(inside, 20.0) << name << ": a stick that points at the camera has the least";
      EXPECT_GT(inside, 0.9 * total) << name;
    }
  }
}

TEST(ScenarioShapes, BallsHaveTheirRadiusAsExtent) {
  const ScenarioRun run = scenarioRun("S12-one-patch");
  ASSERT_EQ(run.extents.size(), run.truth.samples.size());
  EXPECT_EQ(run.extents.front().radius, 0.035);
  EXPECT_EQ(run.extents.back().halfAxes, Eigen::Vector3d::Constant(0.035));
}

TEST(ScenarioClicked, TheRangeIsThatOfOneClickOnTheDisc) {
  for (const char* word : {"pink", "orange", "blue", "red", "yellow", "green"}) {
    const ScenarioRun run = scenarioRun(std::string("S22-") + word);
    const Target& target = run.targets.front();
    ASSERT_GE(target.samples.size(), 1U) << word;
    const ColorSample& click = target.samples.front();
    EXPECT_FALSE(click.isFoundByGeometry) << word;
    // The others were found from it, on the disc.
    for (std::size_t i = 1; i < target.samples.size(); ++i) {
      const ColorSample& found = target.samples[i];
      const auto& other = run.trueRig.at(static_cast<std::size_t>(found.camera));
      const ImageDisc shown = discOf(other, truthAt(run, 0).front(), target.radius);
      EXPECT_TRUE(found.isFoundByGeometry) << word;
      EXPECT_LE((Eigen::Vector2d(found.x, found.y) - shown.center).norm(), 1.1 * shown.radius)
          << word;
    }
    const auto camera = static_cast<std::size_t>(click.camera);
    const ImageDisc disc = discOf(run.trueRig.at(camera), truthAt(run, 0).front(), target.radius);
    // Within 0.8 radii, rounded to a whole pixel. 25 degrees off the optical axis a disc is longer
    // by 1 / cos 25 degrees, a tenth.
    EXPECT_LE((Eigen::Vector2d(click.x, click.y) - disc.center).norm(), 0.88 * disc.radius + 1.0)
        << word;
    // The learner gives up a part of the ball where the room has the same color.
    const FrameSetPtr set = run.frames(0);
    EXPECT_GT(matchingShare(set->frames[camera]->image, target.color, disc), 0.3) << word;
  }
}

TEST(ScenarioClicked, TheGrayBallHasARunToo) {
  const ScenarioRun run = scenarioRun("S22-gray");
  EXPECT_EQ(run.frameCount, 180);
  EXPECT_TRUE(checkColorRange(run.targets.front().color));
}

TEST(ScenarioClicked, SameSeedSameClick) {
  const ScenarioRun one = scenarioRun("S22-blue");
  const ScenarioRun same = scenarioRun("S22-blue");
  const ScenarioRun other = scenarioRun("S22-blue", 2);
  EXPECT_EQ(one.targets, same.targets);
  EXPECT_NE(one.targets, other.targets);
}

} // namespace
} // namespace dewpoint::tests
