// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/people/people_ways.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dewpoint::experiment {

using Eigen::Vector2d;
using simulation::Walker;
using simulation::Waypoint;

Vector2d headingVector(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

bool isWalkable(const Vector2d& position) {
  // Meters: the furniture of furnishOffice() with about 0.25 m around it.
  const double x = position.x();
  const double y = position.y();
  const bool desks = std::abs(x) > 1.6 && std::abs(y - std::copysign(0.9, x)) < 1.15;
  const bool partition = x < -0.9 && y < -1.1;
  return std::abs(x) < 2.6 && std::abs(y) < 2.6 && !desks && !partition;
}

bool isPathFree(const Walker& walker) {
  return std::ranges::all_of(walker.waypoints,
                             [](const Waypoint& point) { return isWalkable(point.position); });
}

Walker makeNumberedWalker(int number) {
  Walker walker;
  walker.name = fmt::format("person {}", number);
  walker.presentFrom = kAppearTime;
  return walker;
}

void addCrossingPeople(PeopleScenario& scenario, const GapRange& gapRange, RandomDraws& draws) {
  constexpr double kHalf =
      2.1; // seconds from the beginning to the nearest point; chosen: 2 m of way
  const double nearest = kAppearTime + kHalf;
  const Vector2d middle(draws.drawUniform(-0.4, 0.4), draws.drawUniform(-0.4, 0.4));
  const double angle = draws.drawUniform(0.0, kFullTurn);
  const double turn = draws.drawUniform(1.2, std::numbers::pi);
  const std::array<Vector2d, 2> velocity{draws.drawUniform(0.85, 1.1) * headingVector(angle),
                                         draws.drawUniform(0.85, 1.1) *
                                             headingVector(angle + turn)};
  const Vector2d along = (velocity[1] - velocity[0]).normalized();
  const Vector2d gap =
      draws.drawUniform(gapRange.low, gapRange.high) * Vector2d(-along.y(), along.x());
  for (int k = 0; k < 2; ++k) {
    Walker walker = makeNumberedWalker(k + 1);
    const Vector2d position = middle + (k == 0 ? -0.5 : 0.5) * gap;
    const Vector2d& pace = velocity.at(static_cast<std::size_t>(k));
    walker.waypoints = {{kAppearTime, position - kHalf * pace},
                        {nearest + kHalf, position + kHalf * pace}};
    scenario.scene.people.push_back(walker);
  }
  scenario.timeBeforeMeeting = nearest - 0.9;
  scenario.timeAfterMeeting = nearest + kHalf;
}

void addMeetingPeople(PeopleScenario& scenario, const GapRange& gapRange, RandomDraws& draws) {
  const Vector2d middle(draws.drawUniform(-0.4, 0.4), draws.drawUniform(-0.4, 0.4));
  const Vector2d line = headingVector(draws.drawUniform(0.0, kFullTurn));
  const double gap = draws.drawUniform(gapRange.low, gapRange.high);
  const double stay = draws.drawUniform(1.0, 2.0);
  const double reach = draws.drawUniform(1.6, 1.9);
  const double arrive = kAppearTime + reach / draws.drawUniform(0.9, 1.1);
  for (int k = 0; k < 2; ++k) {
    Walker walker = makeNumberedWalker(k + 1);
    const Vector2d way = (k == 0 ? -1.0 : 1.0) * line;
    // Not quite the way they came.
    const double aside = draws.drawUniform(-0.4, 0.4);
    const Vector2d back = reach * (way + aside * Vector2d(-way.y(), way.x()));
    walker.waypoints = {{kAppearTime, middle + reach * way},
                        {arrive, middle + 0.5 * gap * way},
                        {arrive + stay, middle + 0.5 * gap * way},
                        {arrive + stay + reach, middle + back}};
    scenario.scene.people.push_back(walker);
  }
  scenario.timeBeforeMeeting = arrive - 0.7;
  scenario.timeAfterMeeting = arrive + stay + reach;
}

void addAccompanyingPeople(PeopleScenario& scenario, RandomDraws& draws) {
  const Vector2d middle(draws.drawUniform(-0.3, 0.3), draws.drawUniform(-0.3, 0.3));
  const Vector2d along = headingVector(draws.drawUniform(0.0, kFullTurn));
  const Vector2d aside(-along.y(), along.x());
  const double gap = draws.drawUniform(0.5, 0.62);
  const double pace = draws.drawUniform(0.75, 0.95);
  const double together = 1.3; // meters before and after the middle
  const double join = kAppearTime + 1.2;
  const double part = join + 2.0 * together / pace;
  for (int k = 0; k < 2; ++k) {
    Walker walker = makeNumberedWalker(k + 1);
    const double side = k == 0 ? -1.0 : 1.0;
    const Vector2d near = 0.5 * side * gap * aside;
    const Vector2d far = draws.drawUniform(0.9, 1.2) * side * aside;
    walker.waypoints = {{kAppearTime, middle - (together + 0.5) * along + far},
                        {join, middle - together * along + near},
                        {part, middle + together * along + near},
                        {part + 1.3, middle + (together + 0.5) * along + far}};
    scenario.scene.people.push_back(walker);
  }
  scenario.timeBeforeMeeting = join - 0.6;
  scenario.timeAfterMeeting = part + 1.3;
}

void addDistantPeople(PeopleScenario& scenario, RandomDraws& draws) {
  for (int k = 0; k < 2; ++k) {
    Walker walker = makeNumberedWalker(k + 1);
    const double side = k == 0 ? -1.0 : 1.0;
    walker.waypoints = {
        {kAppearTime, {draws.drawUniform(-1.2, 1.2), side * draws.drawUniform(1.2, 1.6)}},
        {kAppearTime + 4.0, {draws.drawUniform(-1.2, 1.2), side * draws.drawUniform(1.2, 1.6)}}};
    scenario.scene.people.push_back(walker);
  }
  scenario.timeBeforeMeeting = kAppearTime + 1.0;
  scenario.timeAfterMeeting = kAppearTime + 4.0;
}

void addVisitors(PeopleScenario& scenario, RandomDraws& draws) {
  // Outside and inside of the four doors.
  static const std::array<std::array<Vector2d, 2>, 4> kDoors{
      {{Vector2d(-4.2, 1.3), Vector2d(-2.2, 0.8)},
       {Vector2d(4.2, -1.3), Vector2d(2.2, -0.8)},
       {Vector2d(0.05, 4.2), Vector2d(0.1, 2.2)},
       {Vector2d(0.6, -4.2), Vector2d(0.5, -2.2)}}};
  double start = kAppearTime;
  std::size_t door = static_cast<std::size_t>(draws.drawUniform(0.0, 4.0));
  for (int k = 0; k < 3; ++k) {
    Walker walker = makeNumberedWalker(k + 1);
    walker.presentFrom = -1.0;
    const auto& in = kDoors.at(door % 4);
    const auto& out =
        kDoors.at((door + 1 + static_cast<std::size_t>(draws.drawUniform(0.0, 3.0))) % 4);
    const double pace = draws.drawUniform(0.9, 1.2);
    const Vector2d inside(draws.drawUniform(-0.9, 0.9), draws.drawUniform(-0.9, 0.9));
    double time = start;
    walker.waypoints.push_back({time, in[0]});
    for (const Vector2d& position : {in[1], inside, out[1], out[0]}) {
      time += (position - walker.waypoints.back().position).norm() / pace;
      walker.waypoints.push_back({time, position});
    }
    scenario.timeAfterMeeting = std::max(scenario.timeAfterMeeting, time + 1.5);
    scenario.scene.people.push_back(walker);
    start += draws.drawUniform(2.0, 3.0);
    door += 1;
  }
  scenario.timeBeforeMeeting = 0.0;
}

} // namespace dewpoint::experiment
