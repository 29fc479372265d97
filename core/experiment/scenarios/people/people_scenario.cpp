// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/people/people_scenario.h"

#include "core/base/random.h"
#include "core/experiment/scenarios/people/people_everyday.h"
#include "core/experiment/scenarios/people/people_wardrobe.h"
#include "core/experiment/scenarios/people/people_ways.h"
#include "core/experiment/scenarios/random_draws.h"

#include <algorithm>

namespace dewpoint::experiment {
namespace {

/// Draws of ways before a scenario gives up; chosen.
constexpr int kMaxDrawAttempts = 2000;

// Distances between the middles of two people, meters; chosen, as the paper states none: an adult
// here is 0.5 m wide and 0.25 m deep.
constexpr GapRange kCrossing{0.45, 0.6}; ///< shoulder by shoulder
constexpr GapRange kMeeting{0.5, 0.65};  ///< to talk
constexpr GapRange kCarrying{0.6, 0.75}; ///< with a box or a bag between them
constexpr GapRange kContact{0.15, 0.28}; ///< an embrace: the bodies touch

void cross(PeopleScenario& scenario, RandomDraws& draws) {
  addCrossingPeople(scenario, kCrossing, draws);
}
void meet(PeopleScenario& scenario, RandomDraws& draws) {
  addMeetingPeople(scenario, kMeeting, draws);
}
void crossWithLoads(PeopleScenario& scenario, RandomDraws& draws) {
  addCrossingPeople(scenario, kCarrying, draws);
}
void touch(PeopleScenario& scenario, RandomDraws& draws) {
  addMeetingPeople(scenario, kContact, draws);
}

bool waypointsWalkable(const PeopleScenario& scenario) {
  return std::ranges::all_of(scenario.scene.people,
                             [](const simulation::Walker& walker) { return isPathFree(walker); });
}

/// Nobody comes nearer than people who walk past each other.
bool visitPossible(const PeopleScenario& scenario) {
  constexpr double kCheckEvery = 0.1; // seconds, in which somebody walks 0.1 m
  const auto& people = scenario.scene.people;
  for (double time = 0.0; time < scenario.timeAfterMeeting; time += kCheckEvery) {
    for (std::size_t a = 0; a < people.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        if ((people[a].positionAt(time) - people[b].positionAt(time)).norm() < kCrossing.low) {
          return false;
        }
      }
    }
  }
  return true;
}

/// A scenario. Ways are drawn until they are possible, then people are dressed; what is special
/// comes last.
struct Recipe {
  std::string name;
  std::string description;
  void (*draw)(PeopleScenario&, RandomDraws&);
  bool (*possible)(const PeopleScenario&) = waypointsWalkable;
  void (*finish)(PeopleScenario&, PeopleClothes, RandomDraws&) = nullptr;
  bool ofPaper = false; ///< a scene of Mohedano et al. 2009
};

const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> all{
      {"crossing", "Two people walk past each other, 0.45 to 0.6 m apart.", cross,
       waypointsWalkable, nullptr, true},
      {"meet-and-turn", "Two people come within 0.5 to 0.65 m, stand, and go back.", meet,
       waypointsWalkable, nullptr, true},
      {"side-by-side", "Two people walk side by side, 0.5 to 0.62 m apart, and part.",
       addAccompanyingPeople, waypointsWalkable, nullptr, true},
      {"enter-leave",
       "Three people come in through doors, walk past each other, and leave through other doors.",
       addVisitors, visitPossible, nullptr, true},
      {"apart", "Two people who stay far from each other.", addDistantPeople, waypointsWalkable,
       nullptr, true},
      {"heights", "A child of 0.9 to 1.3 m, one person of 1.3 to 1.6 m and one of 1.88 to 2 m.",
       addStrollingPeople, isStrollPossible, setVariedHeights},
      {"sitting", "One person sits down on a stool and rises, one crouches, one walks by.",
       addSittingPeople, isSittingPossible, addStool},
      {"carrying", "Two people walk past each other, one with a box in front, one with a bag.",
       crossWithLoads, waypointsWalkable, addCarriedObjects},
      {"crowd", "Five to eight people mill about; their paths may touch and cross.", addCrowd,
       isCrowdPossible, setCrowdHeights},
      {"two-cameras", "Two people walk past each other, seen by only two of the cameras.", cross,
       waypointsWalkable, keepTwoCameras},
      {"contact", "Two people come within 0.15 to 0.28 m, stand, and go back.", touch},
      {"furniture-moved",
       "A cabinet and a stool are moved after the cameras have learned the background.",
       addPeopleAndMovedFurniture, isMovedFurniturePossible},
      {"room-clothes", "Two people in clothes of the colors of the room walk past each other.",
       cross, waypointsWalkable, dressLikeTheRoom},
      {"patterned-clothes",
       "Two people in striped, checked or blotched shirts walk past each other.", cross,
       waypointsWalkable, dressInPatterns},
  };
  return all;
}

const Recipe* recipeNamed(const std::string& name) {
  const auto found = std::ranges::find(recipes(), name, &Recipe::name);
  return found == recipes().end() ? nullptr : &*found;
}

} // namespace

const std::vector<std::string>& peopleScenarioNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Recipe& recipe : recipes()) {
      all.push_back(recipe.name);
    }
    return all;
  }();
  return names;
}

std::string peopleScenarioDescription(const std::string& name) {
  const Recipe* recipe = recipeNamed(name);
  return recipe == nullptr ? std::string() : recipe->description;
}

bool isPeopleScenarioOfPaper(const std::string& name) {
  const Recipe* recipe = recipeNamed(name);
  return recipe != nullptr && recipe->ofPaper;
}

Result<PeopleScenario> makePeopleScenario(const std::string& name, PeopleClothes clothes,
                                          std::uint64_t seed) {
  const Recipe* recipe = recipeNamed(name);
  if (recipe == nullptr) {
    return failure(ErrorCode::NotFound, "", "scenario", name);
  }
  RandomDraws draws(RandomStream(seed, 0, 0, RandomPurpose::Simulation));
  for (int k = 0; k < kMaxDrawAttempts; ++k) {
    PeopleScenario scenario;
    recipe->draw(scenario, draws);
    if (recipe->possible(scenario)) {
      dress(scenario.scene.people, clothes, draws);
      if (recipe->finish != nullptr) {
        recipe->finish(scenario, clothes, draws);
      }
      scenario.scene.seed = seed;
      scenario.scene.frameCount =
          static_cast<std::int64_t>(scenario.timeAfterMeeting * scenario.scene.framesPerSecond) + 1;
      return scenario;
    }
  }
  return failure(ErrorCode::Undetermined, "", "scenario", name + ": no room for it");
}

} // namespace dewpoint::experiment
