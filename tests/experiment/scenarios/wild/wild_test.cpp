// SPDX-License-Identifier: GPL-3.0-or-later
// Cameras, furniture and people of grade `wild`.
#include "core/experiment/scenarios/catalog/catalog.h"
#include "core/experiment/scenarios/scenario.h"
#include "core/experiment/scenarios/wild/wild_rig.h"
#include "core/experiment/scenarios/wild/wild_room.h"
#include "core/simulation/scene/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace dewpoint::tests {
namespace {

using namespace dewpoint::experiment::scenarios;
using simulation::Furnishing;

double targetPixels(const WildRig& wild) {
  const Camera& camera = wild.rig.front();
  const double distance = (camera.center() - Eigen::Vector3d(0.5, 0.5, 0.15)).norm();
  return 2.0 * 0.035 * wild.radiusScale * camera.intrinsics.focalX / distance;
}

TEST(WildRig, ShowsTargetsFromFourPixelsToHalfTheImage) {
  double smallest = 1e9;
  double largest = 0.0;
  int small = 0;
  int large = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    RandomDraws draws(seed, "wild rig test");
    const WildRig wild = randomRig(simulation::demoRig(), Furnishing::ClutteredDesk, 0, draws);
    const double pixels = targetPixels(wild);
    small += pixels < 8.0 ? 1 : 0;
    large += pixels > 80.0 ? 1 : 0;
    smallest = std::min(smallest, pixels);
    largest = std::max(largest, pixels);
    EXPECT_LE(wild.radiusScale, 1.0);
    EXPECT_LE(wild.pathScale, 1.0);
    for (const Camera& camera : wild.rig) {
      EXPECT_GE(camera.center().z(), 0.06 - 1e-9); // as the pose gives it back
      EXPECT_GE(std::min(camera.intrinsics.width, camera.intrinsics.height), 120);
      const double across = camera.intrinsics.width / camera.intrinsics.focalX;
      EXPECT_LT(across, 2.4) << "a lens of 100 degrees at most";
      EXPECT_NEAR(camera.intrinsics.centerX, 0.5 * (camera.intrinsics.width - 1), 1e-12);
    }
  }
  // 4 to 120 pixels evenly in the logarithm, and lenses that differ by 10 %.
  EXPECT_GT(smallest, 3.3);
  EXPECT_LT(smallest, 6.0);
  EXPECT_GT(largest, 80.0);
  EXPECT_LT(largest, 133.0);
  // ln(8 / 4) / ln(120 / 4) = 0.20 of 200, 41 with a standard deviation of 6, and ln(120 / 80) of
  // it, 24 with one of 5.
  EXPECT_GT(small, 20);
  EXPECT_GT(large, 8);
}

TEST(WildRig, LaterAttemptsHaveTheUsualSizeAtMost) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    RandomDraws draws(seed, "wild rig test");
    const WildRig wild =
        randomRig(simulation::demoRig(), Furnishing::ClutteredDesk, kMaxRigAttempts - 1, draws);
    // 350 pixels, and lenses that differ by 10 %.
    EXPECT_LE(wild.rig.front().intrinsics.focalX, 350.0 * 1.1 + 1e-9);
  }
}

TEST(WildRoom, LeavesTheMiddleAndTheCamerasFree) {
  const CameraRig rig = simulation::demoRig();
  std::size_t objects = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomDraws draws(seed, "wild room test");
    const simulation::RoomDesign design = randomRoom(Furnishing::ClutteredDesk, rig, draws);
    ASSERT_TRUE(design.wallMaterial);
    ASSERT_TRUE(design.lampPosition);
    EXPECT_GT(design.lampPosition->z(), 1.2F);
    EXPECT_LT(design.lampPosition->z(), 2.0F) << "below the ceiling, z = 2.05";
    for (const simulation::Solid& solid : design.additionalFurniture.solids()) {
      ++objects;
      const auto apart = [&](double x, double y) {
        return std::hypot(solid.center.x() - x, solid.center.y() - y);
      };
      EXPECT_GT(apart(0.47, 0.47), 0.19);
      for (const Camera& camera : rig) {
        EXPECT_GT(apart(camera.center().x(), camera.center().y()), 0.19);
      }
    }
    RandomDraws again(seed, "wild room test");
    EXPECT_EQ(randomRoom(Furnishing::ClutteredDesk, rig, again).additionalFurniture.solids().size(),
              design.additionalFurniture.solids().size());
  }
  EXPECT_GT(objects, 20U * 7U);
}

/// Whether a color (BGR) is another one, perhaps darker.
bool isToneOf(const simulation::Vector3f& color, const Eigen::Vector3d& other) {
  return color.cast<double>().normalized().dot(other.normalized()) > 0.9999;
}

TEST(WildRoom, SomeOfItHasTheTargetsColor) {
  const Eigen::Vector3d blue{220.0, 90.0, 40.0};
  int objects = 0;
  int walls = 0;
  int shirts = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    RandomDraws draws(seed, "wild color test");
    const simulation::RoomDesign design =
        randomRoom(Furnishing::ClutteredDesk, simulation::demoRig(), draws, blue);
    for (const simulation::Solid& solid : design.additionalFurniture.solids()) {
      objects += isToneOf(solid.material.color, blue) ? 1 : 0;
    }
    walls += isToneOf(design.wallMaterial->color, blue) ? 1 : 0;
    for (const simulation::Walker& walker : randomPeople(Furnishing::Desk, 6.0, draws, blue)) {
      shirts += isToneOf(walker.clothes.shirt, blue) ? 1 : 0;
    }
  }
  // 15 % of about 500 objects and of 40 walls, 30 % of about 60 shirts.
  EXPECT_GT(objects, 40);
  EXPECT_GT(walls, 0);
  EXPECT_GT(shirts, 5);
}

TEST(WildRoom, PeopleWalkBehindTheVolume) {
  std::size_t people = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomDraws draws(seed, "people test");
    for (const simulation::Walker& walker : randomPeople(Furnishing::Desk, 6.0, draws)) {
      ++people;
      for (const double time : {0.0, 3.0, 6.0}) {
        const Eigen::Vector2d position = walker.positionAt(time);
        EXPECT_NEAR(position.maxCoeff(), std::max(1.75, position.minCoeff()), 0.16);
        EXPECT_GT(position.minCoeff(), -1.1);
      }
    }
    EXPECT_TRUE(randomPeople(Furnishing::Hall, 6.0, draws).empty());
  }
  EXPECT_GT(people, 10U);
  EXPECT_EQ(floorHeightOf(Furnishing::ClutteredDesk), -0.75F);
}

TEST(WildGrade, GivesEverySeedItsOwnCameras) {
  const auto scenario = std::ranges::find(scenarioCatalog(), "S0-slow", &ScenarioDeclaration::name);
  const auto one = scenario->make(1, Grade::Wild);
  const auto other = scenario->make(2, Grade::Wild);
  ASSERT_TRUE(one);
  ASSERT_TRUE(other);
  ASSERT_EQ(one->trueRig.size(), 2U);
  EXPECT_NE(one->trueRig[0].center(), other->trueRig[0].center());
  EXPECT_NE(one->rig[0], one->trueRig[0]);
  const FramePtr first = one->frames(0)->frames[1];
  ASSERT_NE(first, nullptr) << "frame 0 always comes";
  EXPECT_EQ(first->image.cols, one->trueRig[1].intrinsics.width);
  EXPECT_EQ(first->image.rows, one->trueRig[1].intrinsics.height);
}

// A rig in which no path is found is replaced by one nearer to the usual size, but not always.
TEST(WildGrade, HasRunsWithTinyAndWithHugeTargets) {
  const auto scenario = std::ranges::find(scenarioCatalog(), "S0-slow", &ScenarioDeclaration::name);
  double smallest = 1e9;
  double largest = 0.0;
  for (std::uint64_t seed = 1; seed <= 60 && (smallest >= 8.0 || largest <= 80.0); ++seed) {
    RandomDraws draws(seed, "S0-slow wild 0"); // the run's own: only those of interest are made
    const double wanted =
        targetPixels(randomRig(simulation::demoRig(), Furnishing::ClutteredDesk, 0, draws));
    const bool isInVolumeOfInterest =
        (wanted < 8.0 && smallest >= 8.0) || (wanted > 80.0 && largest <= 80.0);
    const auto run = isInVolumeOfInterest
                         ? scenario->make(seed, Grade::Wild)
                         : Result<ScenarioRun>(failure(ErrorCode::Undetermined, "", "", ""));
    if (run) {
      WildRig own;
      own.rig = run->trueRig;
      own.radiusScale = run->targets.front().radius / 0.035;
      smallest = std::min(smallest, targetPixels(own));
      largest = std::max(largest, targetPixels(own));
    }
  }
  EXPECT_LT(smallest, 8.0);
  EXPECT_GT(largest, 80.0);
}

} // namespace
} // namespace dewpoint::tests
