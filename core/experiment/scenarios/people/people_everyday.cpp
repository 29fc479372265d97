// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/people/people_everyday.h"

#include "core/experiment/scenarios/people/people_ways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace dewpoint::experiment {
namespace {

using Eigen::Vector2d;
using simulation::kPostureSeconds;
using simulation::MovableFurniture;
using simulation::Posture;
using simulation::rgb;
using simulation::Walker;

// All lengths in meters, all times in seconds; chosen to be what is usual in an office.
constexpr double kCheckStep = 0.1;   ///< along ways and times, of checks
constexpr double kLeastPace = 0.8;   ///< m/s: strolling
constexpr double kMostPace = 1.1;    ///< m/s
constexpr double kAside = 0.6;       ///< least distance of people who do not meet
constexpr double kBodyRadius = 0.25; ///< of the circle on the floor that somebody needs

/// A point in the middle of the office.
Vector2d drawPoint(RandomDraws& draws) {
  const double x = draws.drawUniform(-1.5, 1.5);
  return {x, draws.drawUniform(-2.3, 2.3)};
}

bool isWalkableLine(const Vector2d& from, const Vector2d& to) {
  const auto steps = static_cast<int>(std::ceil((to - from).norm() / kCheckStep));
  for (int k = 0; k <= steps; ++k) {
    if (!isWalkable(from + (to - from) * (static_cast<double>(k) / std::max(1, steps)))) {
      return false;
    }
  }
  return true;
}

constexpr int kTries = 50; ///< for a next point that can be reached in a straight line

/// A point of drawPoint() that can be reached; any point when none is found.
Vector2d drawReachable(const Vector2d& from, RandomDraws& draws) {
  Vector2d next = drawPoint(draws);
  for (int k = 0; k < kTries && !isWalkableLine(from, next); ++k) {
    next = drawPoint(draws);
  }
  return next;
}

/// A point that can be reached, 1 to 1.5 m away in about the direction of `angle` (radians).
Vector2d drawReachable(const Vector2d& from, double angle, RandomDraws& draws) {
  constexpr double kSpread = 1.2; // radians to either side
  Vector2d next = from;
  for (int k = 0; k <= kTries && (k == 0 || !isWalkableLine(from, next)); ++k) {
    const double distance = draws.drawUniform(1.0, 1.5);
    next = from + distance * headingVector(angle + draws.drawUniform(-kSpread, kSpread));
  }
  return next;
}

bool isWalkableWay(const Walker& walker) {
  for (std::size_t k = 1; k < walker.waypoints.size(); ++k) {
    if (!isWalkableLine(walker.waypoints[k - 1].position, walker.waypoints[k].position)) {
      return false;
    }
  }
  return true;
}

/// Walks on to `position`; returns when that is reached.
double walkTo(Walker& walker, const Vector2d& position, double pace) {
  const double time =
      walker.waypoints.back().time + (position - walker.waypoints.back().position).norm() / pace;
  walker.waypoints.push_back({time, position});
  return time;
}

/// Stays for some time.
void stay(Walker& walker, double seconds) {
  walker.waypoints.push_back(
      {walker.waypoints.back().time + seconds, walker.waypoints.back().position});
}

/// Whether nobody comes nearer to somebody else than `least`.
bool keepApart(const PeopleScenario& scenario, double least) {
  const auto& people = scenario.scene.people;
  for (double time = kAppearTime; time < scenario.timeAfterMeeting; time += kCheckStep) {
    for (std::size_t a = 0; a < people.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        if ((people[a].positionAt(time) - people[b].positionAt(time)).norm() < least) {
          return false;
        }
      }
    }
  }
  return true;
}

/// Whether somebody keeps off a circle on the floor.
bool keepsOff(const Walker& walker, const Vector2d& center, double radius, double until) {
  for (double time = kAppearTime; time < until; time += kCheckStep) {
    if ((walker.positionAt(time) - center).norm() < radius) {
      return false;
    }
  }
  return true;
}

void addStrolls(PeopleScenario& scenario, int count, RandomDraws& draws) {
  constexpr int kLegs = 2; // straight ways of each
  for (int k = 0; k < count; ++k) {
    Walker walker = makeNumberedWalker(k + 1);
    const double pace = draws.drawUniform(kLeastPace, kMostPace);
    walker.waypoints.push_back({kAppearTime, drawPoint(draws)});
    for (int leg = 0; leg < kLegs; ++leg) {
      const Vector2d next = drawReachable(walker.waypoints.back().position, draws);
      scenario.timeAfterMeeting = std::max(scenario.timeAfterMeeting, walkTo(walker, next, pace));
    }
    scenario.scene.people.push_back(std::move(walker));
  }
  scenario.timeBeforeMeeting = kAppearTime + 1.0;
  scenario.timeAfterMeeting = std::max(scenario.timeAfterMeeting, scenario.timeBeforeMeeting + 2.0);
}

/// Walks to a point, takes a posture there, rises and walks on.
Walker pausing(int number, Posture posture, const Vector2d& at, double rest, RandomDraws& draws) {
  Walker walker = makeNumberedWalker(number);
  const double pace = draws.drawUniform(kLeastPace, kMostPace);
  const double angle = draws.drawUniform(0.0, kFullTurn); // that the person faces
  walker.waypoints.push_back({kAppearTime, drawReachable(at, angle + std::numbers::pi, draws)});
  // A moment to stand still before and after: ways have rounded corners.
  constexpr double kStand = 0.3;
  const double down = walkTo(walker, at, pace) + kStand;
  const double up = down + kPostureSeconds + rest;
  stay(walker, up + kPostureSeconds + kStand - walker.waypoints.back().time);
  walkTo(walker, drawReachable(at, angle, draws), pace);
  walker.postures = {{down, posture}, {up, Posture::Standing}};
  return walker;
}

constexpr double kGlide = 1.0; ///< seconds in which furniture is moved

/// A piece of furniture that glides from one drawn point to another, from `since` on.
void addMoved(PeopleScenario& scenario, MovableFurniture furniture, double since,
              RandomDraws& draws) {
  const Vector2d from = drawPoint(draws);
  const double yaw = draws.drawUniform(0.0, kFullTurn);
  const double distance = draws.drawUniform(0.8, 1.5);
  const Vector2d to = from + distance * headingVector(draws.drawUniform(0.0, kFullTurn));
  furniture.waypoints = {{since, from, yaw},
                         {since + kGlide, to, yaw + draws.drawUniform(-0.8, 0.8)}};
  scenario.scene.furniture.push_back(std::move(furniture));
}

} // namespace

void addStrollingPeople(PeopleScenario& scenario, RandomDraws& draws) {
  addStrolls(scenario, 3, draws);
}

bool isStrollPossible(const PeopleScenario& scenario) {
  return std::ranges::all_of(scenario.scene.people, isWalkableWay) && keepApart(scenario, kAside);
}

void setVariedHeights(PeopleScenario& scenario, PeopleClothes /*clothes*/, RandomDraws& draws) {
  // Meters: a child of 2 to 8, a child of 8 to 13 or a small adult, a tall adult.
  static constexpr std::array<std::array<double, 2>, 3> kRanges{
      {{0.9, 1.3}, {1.3, 1.6}, {1.88, 2.0}}};
  for (std::size_t k = 0; k < kRanges.size(); ++k) {
    scenario.scene.people.at(k).height = draws.drawUniform(kRanges.at(k)[0], kRanges.at(k)[1]);
  }
}

void addSittingPeople(PeopleScenario& scenario, RandomDraws& draws) {
  constexpr double kLeastRest = 2.0; // of somebody who sits; half of it and more of who crouches
  constexpr double kMostRest = 3.5;
  auto& people = scenario.scene.people;
  const Vector2d stool = drawPoint(draws);
  people.push_back(
      pausing(1, Posture::Sitting, stool, draws.drawUniform(kLeastRest, kMostRest), draws));
  const Vector2d floor = drawPoint(draws);
  people.push_back(pausing(2, Posture::Crouching, floor,
                           draws.drawUniform(0.5 * kLeastRest, kLeastRest), draws));
  Walker passer = makeNumberedWalker(3);
  passer.waypoints.push_back({kAppearTime, drawPoint(draws)});
  const double pace = draws.drawUniform(kLeastPace, kMostPace);
  walkTo(passer, drawReachable(passer.waypoints.back().position, draws), pace);
  walkTo(passer, drawReachable(passer.waypoints.back().position, draws), pace);
  people.push_back(std::move(passer));
  for (const Walker& walker : people) {
    scenario.timeAfterMeeting = std::max(scenario.timeAfterMeeting, walker.waypoints.back().time);
  }
  scenario.timeBeforeMeeting = kAppearTime + 1.0; // all stand or walk until then
}

bool isSittingPossible(const PeopleScenario& scenario) {
  constexpr double kLegroom = 0.8; // nobody walks over the feet of somebody who sits
  const auto& people = scenario.scene.people;
  const Vector2d stool = people.front().waypoints.at(1).position;
  return std::ranges::all_of(people, isWalkableWay) && keepApart(scenario, kAside) &&
         keepsOff(people.at(1), stool, kLegroom, scenario.timeAfterMeeting) &&
         keepsOff(people.at(2), stool, kLegroom, scenario.timeAfterMeeting);
}

void addStool(PeopleScenario& scenario, PeopleClothes /*clothes*/, RandomDraws& /*draws*/) {
  const Walker& sitter = scenario.scene.people.front();
  MovableFurniture stool = simulation::makeStool(simulation::seatHeight(sitter.height));
  stool.waypoints = {{0.0, sitter.waypoints.at(1).position, 0.0}};
  scenario.scene.furniture.push_back(std::move(stool));
}

void addCarriedObjects(PeopleScenario& scenario, PeopleClothes /*clothes*/, RandomDraws& draws) {
  using simulation::CarriedObject;
  CarriedObject box;
  const auto half = [&](double least, double most) {
    return static_cast<float>(0.5 * draws.drawUniform(least, most));
  };
  const float boxDepth = half(0.25, 0.4);
  const float boxWidth = half(0.3, 0.5);
  box.halfSize = {boxDepth, boxWidth, half(0.2, 0.4)};
  CarriedObject bag;
  bag.kind = CarriedObject::Kind::Bag;
  const float bagLength = half(0.3, 0.5);
  bag.halfSize = {bagLength, half(0.12, 0.2), half(0.25, 0.4)};
  bag.color = rgb(52, 50, 58);
  scenario.scene.people.at(0).carriedObject = box;
  scenario.scene.people.at(1).carriedObject = bag;
}

void addCrowd(PeopleScenario& scenario, RandomDraws& draws) {
  constexpr int kFewest = 5; // people; chosen: as many as find room to walk in the office
  constexpr int kMost = 8;
  constexpr double kMillSeconds = 12.0;
  const int count = draws.drawInteger(kFewest, kMost);
  for (int k = 0; k < count; ++k) {
    Walker walker = makeNumberedWalker(k + 1);
    const double pace = draws.drawUniform(kLeastPace, kMostPace);
    walker.waypoints.push_back({kAppearTime, drawPoint(draws)});
    while (walker.waypoints.back().time < kAppearTime + kMillSeconds) {
      walkTo(walker, drawReachable(walker.waypoints.back().position, draws), pace);
      stay(walker, draws.drawUniform(0.2, 1.0));
    }
    scenario.scene.people.push_back(std::move(walker));
  }
  scenario.timeBeforeMeeting = kAppearTime + 1.0;
  scenario.timeAfterMeeting = kAppearTime + kMillSeconds;
}

bool isCrowdPossible(const PeopleScenario& scenario) {
  const auto& people = scenario.scene.people;
  for (std::size_t a = 0; a < people.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b) {
      if ((people[a].waypoints.front().position - people[b].waypoints.front().position).norm() <
          kAside) {
        return false;
      }
    }
  }
  return std::ranges::all_of(people, isWalkableWay);
}

void setCrowdHeights(PeopleScenario& scenario, PeopleClothes /*clothes*/, RandomDraws& draws) {
  for (Walker& person : scenario.scene.people) {
    person.height = draws.drawUniform(1.5, 2.0); // adults
  }
}

void keepTwoCameras(PeopleScenario& scenario, PeopleClothes /*clothes*/, RandomDraws& draws) {
  CameraRig& rig = scenario.scene.cameras;
  const auto last = static_cast<int>(rig.size()) - 1;
  const int one = draws.drawInteger(0, last);
  const int other = (one + draws.drawInteger(1, last)) % (last + 1);
  rig = {rig[static_cast<std::size_t>(std::min(one, other))],
         rig[static_cast<std::size_t>(std::max(one, other))]};
}

void addPeopleAndMovedFurniture(PeopleScenario& scenario, RandomDraws& draws) {
  addStrolls(scenario, 2, draws);
  const double since = kAppearTime + draws.drawUniform(0.8, 1.8);
  addMoved(scenario, simulation::makeCabinet({0.25F, 0.2F, 0.45F}, rgb(120, 96, 78)), since, draws);
  addMoved(scenario, simulation::makeStool(simulation::seatHeight(simulation::kReferenceHeight)),
           since, draws);
  // What the furniture leaves behind shows later.
  scenario.timeAfterMeeting = std::max(scenario.timeAfterMeeting, since + kGlide) + 1.0;
}

bool isMovedFurniturePossible(const PeopleScenario& scenario) {
  const MovableFurniture& first = scenario.scene.furniture.front();
  const MovableFurniture& second = scenario.scene.furniture.back();
  for (double time = kAppearTime; time < scenario.timeAfterMeeting; time += kCheckStep) {
    if ((first.poseAt(time).position - second.poseAt(time).position).norm() <
        first.enclosingRadius + second.enclosingRadius) {
      return false;
    }
  }
  for (const MovableFurniture& piece : scenario.scene.furniture) {
    const Vector2d from = piece.waypoints.front().position;
    const Vector2d to = piece.waypoints.back().position;
    if (!isWalkableLine(from, to)) {
      return false;
    }
    // Off the whole strip: furniture glides in a straight line.
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const Vector2d point = from + share * (to - from);
      for (const Walker& walker : scenario.scene.people) {
        if (!keepsOff(walker, point, piece.enclosingRadius + kBodyRadius,
                      scenario.timeAfterMeeting)) {
          return false;
        }
      }
    }
  }
  return isStrollPossible(scenario);
}

} // namespace dewpoint::experiment
