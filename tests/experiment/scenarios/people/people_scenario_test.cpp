// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/people/people_scenario.h"
#include "core/experiment/scenarios/people/people_ways.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

namespace dewpoint::tests {
namespace {

using simulation::Posture;
using simulation::Walker;

constexpr std::uint64_t kSeeds = 5;

/// The first seeds of a scenario.
std::vector<PeopleScenario> drawn(const std::string& name,
                                  PeopleClothes clothes = PeopleClothes::Different) {
  std::vector<PeopleScenario> all;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    auto scenario = makePeopleScenario(name, clothes, seed);
    EXPECT_TRUE(scenario) << name << " " << seed;
    if (scenario) {
      all.push_back(std::move(*scenario));
    }
  }
  return all;
}

double nearestOfTwo(const PeopleScenario& scenario) {
  const auto& people = scenario.scene.people;
  double nearest = 10.0;
  for (double time = kAppearTime; time < scenario.timeAfterMeeting; time += 0.02) {
    nearest = std::min(nearest, (people[0].positionAt(time) - people[1].positionAt(time)).norm());
  }
  return nearest;
}

// What seed 1 of "apart" and seed 2 of "crossing" drew before there were other scenes: computed
// from the definition of Philox4x32-10 and the order of their draws. Both are possible at once.
TEST(PeopleScenario, ThePapersScenesAreAsEver) {
  const auto apart = makePeopleScenario("apart", PeopleClothes::Different, 1);
  ASSERT_TRUE(apart);
  const auto& people = apart->scene.people;
  ASSERT_EQ(people.size(), 2U);
  EXPECT_NEAR(people[0].waypoints[0].position.x(), 0.8000123690332497, 1e-12);
  EXPECT_NEAR(people[0].waypoints[0].position.y(), -1.5881642334265043, 1e-12);
  EXPECT_NEAR(people[1].waypoints[1].position.x(), 0.34854626320060755, 1e-12);
  EXPECT_NEAR(people[1].waypoints[1].position.y(), 1.4546847246550443, 1e-12);
  EXPECT_NEAR(people[0].height, 1.8222616628213126, 1e-12);
  EXPECT_NEAR(people[1].height, 1.7017518737033526, 1e-12);
  const auto crossing = makePeopleScenario("crossing", PeopleClothes::Different, 2);
  ASSERT_TRUE(crossing);
  EXPECT_NEAR(crossing->scene.people[0].height, 1.7896408370603396, 1e-12);
  EXPECT_NEAR(crossing->scene.people[1].height, 1.6991679559359596, 1e-12);
  for (const std::string& name : peopleScenarioNames()) {
    if (!isPeopleScenarioOfPaper(name)) {
      continue;
    }
    for (const PeopleScenario& scenario : drawn(name)) {
      EXPECT_EQ(scenario.scene.cameras.size(), 4U);
      EXPECT_TRUE(scenario.scene.furniture.empty());
      for (const Walker& walker : scenario.scene.people) {
        EXPECT_TRUE(walker.postures.empty());
        EXPECT_FALSE(walker.carriedObject);
        EXPECT_EQ(walker.clothes.shirtCloth.pattern, simulation::ClothPattern::Plain);
      }
    }
  }
}

TEST(PeopleScenario, EveryNameIsPossibleInBothKindsOfClothes) {
  EXPECT_EQ(peopleScenarioNames().size(), 14U); // the paper's five, and nine more
  for (const std::string& name : peopleScenarioNames()) {
    for (const auto clothes : {PeopleClothes::Different, PeopleClothes::Similar}) {
      for (const PeopleScenario& scenario : drawn(name, clothes)) {
        EXPECT_GT(scenario.timeAfterMeeting, scenario.timeBeforeMeeting) << name;
        EXPECT_LT(scenario.scene.frameCount, 400) << name; // 27 s
      }
    }
  }
  EXPECT_TRUE(isPeopleScenarioOfPaper("apart"));
  EXPECT_FALSE(isPeopleScenarioOfPaper("heights"));
  EXPECT_FALSE(isPeopleScenarioOfPaper("dance"));
}

TEST(PeopleScenario, HeightsHoldAChild) {
  for (const PeopleScenario& scenario : drawn("heights")) {
    const auto& people = scenario.scene.people;
    ASSERT_EQ(people.size(), 3U);
    EXPECT_GE(people[0].height, 0.9);
    EXPECT_LT(people[0].height, 1.3);
    EXPECT_GE(people[1].height, 1.3);
    EXPECT_LT(people[1].height, 1.6);
    EXPECT_GE(people[2].height, 1.88);
    EXPECT_LT(people[2].height, 2.0);
    EXPECT_GT(nearestOfTwo(scenario), 0.55); // 0.6 m every 0.1 s
  }
}

TEST(PeopleScenario, WhoSitsHasAStoolAndRises) {
  for (const PeopleScenario& scenario : drawn("sitting")) {
    const auto& people = scenario.scene.people;
    ASSERT_EQ(people.size(), 3U);
    ASSERT_EQ(people[0].postures.size(), 2U);
    EXPECT_EQ(people[0].postures[0].posture, Posture::Sitting);
    EXPECT_EQ(people[1].postures.at(0).posture, Posture::Crouching);
    EXPECT_TRUE(people[2].postures.empty());
    for (std::size_t k = 0; k < 2; ++k) {
      const Walker& walker = people[k];
      const double down = walker.postures[0].time + simulation::kPostureSeconds;
      const double up = walker.postures[1].time;
      EXPECT_GT(up, down);
      // Stays where it is as long as it is not upright.
      EXPECT_LT((walker.positionAt(down) - walker.positionAt(up)).norm(), 1e-9);
      EXPECT_LT(walker.topHeightAt(down), 0.8 * walker.height); // sitting: 0.77 of the height
      EXPECT_EQ(walker.topHeightAt(scenario.timeAfterMeeting), walker.height);
      EXPECT_GT(walker.postures[0].time, scenario.timeBeforeMeeting);
    }
    ASSERT_EQ(scenario.scene.furniture.size(), 1U);
    const auto& stool = scenario.scene.furniture[0];
    EXPECT_LT(
        (stool.poseAt(0.0).position - people[0].positionAt(people[0].postures[1].time)).norm(),
        1e-9);
  }
}

TEST(PeopleScenario, CarryingIsABoxAndABag) {
  for (const PeopleScenario& scenario : drawn("carrying")) {
    const auto& people = scenario.scene.people;
    ASSERT_TRUE(people.at(0).carriedObject && people.at(1).carriedObject);
    EXPECT_EQ(people[0].carriedObject->kind, simulation::CarriedObject::Kind::Box);
    EXPECT_EQ(people[1].carriedObject->kind, simulation::CarriedObject::Kind::Bag);
  }
}

TEST(PeopleScenario, ACrowdIsOfFiveAndMore) {
  for (const PeopleScenario& scenario : drawn("crowd")) {
    EXPECT_GE(scenario.scene.people.size(), 5U);
    EXPECT_LE(scenario.scene.people.size(), 8U);
    for (const Walker& walker : scenario.scene.people) {
      EXPECT_GE(walker.height, 1.5);
      for (double time = kAppearTime; time < scenario.timeAfterMeeting; time += 0.1) {
        const Eigen::Vector2d position = walker.positionAt(time);
        EXPECT_LT(position.cwiseAbs().maxCoeff(), 2.6); // off the walls
      }
    }
  }
}

TEST(PeopleScenario, TwoCamerasAreTwoOfTheFour) {
  for (const PeopleScenario& scenario : drawn("two-cameras")) {
    const CameraRig& rig = scenario.scene.cameras;
    ASSERT_EQ(rig.size(), 2U);
    EXPECT_GT((rig[0].center() - rig[1].center()).norm(), 6.0); // corners of 6.6 x 6.6 m
  }
}

TEST(PeopleScenario, ContactIsNearerThanThirtyCentimeters) {
  for (const PeopleScenario& scenario : drawn("contact")) {
    EXPECT_LT(nearestOfTwo(scenario), 0.3);
    EXPECT_GT(nearestOfTwo(scenario), 0.14);
  }
}

TEST(PeopleScenario, FurnitureIsMovedAfterPeopleHaveAppeared) {
  for (const PeopleScenario& scenario : drawn("furniture-moved")) {
    ASSERT_EQ(scenario.scene.furniture.size(), 2U);
    for (const auto& piece : scenario.scene.furniture) {
      EXPECT_EQ(piece.poseAt(0.0).position, piece.poseAt(kAppearTime).position);
      const Eigen::Vector2d way =
          piece.poseAt(scenario.timeAfterMeeting).position - piece.poseAt(0.0).position;
      EXPECT_GT(way.norm(), 0.79); // 0.8 to 1.5 m
      EXPECT_LT(piece.waypoints.back().time, scenario.timeAfterMeeting);
    }
  }
}

/// Whether it is a color of the office: of its walls, white and gray furniture, oak, partition,
/// sofa or floor.
bool isRoomColor(const simulation::Vector3f& color) {
  using simulation::rgb;
  const std::array<simulation::Vector3f, 7> room{
      rgb(226, 219, 203), rgb(214, 212, 206), rgb(148, 152, 158), rgb(186, 138, 88),
      rgb(112, 132, 150), rgb(74, 98, 128),   rgb(82, 73, 60)};
  return std::ranges::find(room, color) != room.end();
}

TEST(PeopleScenario, ClothesLikeTheRoomAndPatterned) {
  for (const auto clothes : {PeopleClothes::Different, PeopleClothes::Similar}) {
    for (const PeopleScenario& scenario : drawn("room-clothes", clothes)) {
      for (const Walker& walker : scenario.scene.people) {
        EXPECT_TRUE(isRoomColor(walker.clothes.shirt)) << walker.clothes.shirt.transpose();
        EXPECT_TRUE(isRoomColor(walker.clothes.trousers)) << walker.clothes.trousers.transpose();
      }
    }
  }
  for (const PeopleScenario& scenario : drawn("room-clothes")) {
    EXPECT_NE(scenario.scene.people[0].clothes.shirt, scenario.scene.people[1].clothes.shirt);
  }
  for (const PeopleScenario& scenario : drawn("room-clothes", PeopleClothes::Similar)) {
    EXPECT_EQ(scenario.scene.people[0].clothes.shirt, scenario.scene.people[1].clothes.shirt);
  }
  for (const PeopleScenario& scenario : drawn("patterned-clothes", PeopleClothes::Similar)) {
    const auto& first = scenario.scene.people[0].clothes.shirtCloth;
    const auto& second = scenario.scene.people[1].clothes.shirtCloth;
    EXPECT_NE(first.pattern, simulation::ClothPattern::Plain);
    EXPECT_EQ(first.pattern, second.pattern);
    EXPECT_EQ(first.secondColor, second.secondColor);
  }
}

} // namespace
} // namespace dewpoint::tests
