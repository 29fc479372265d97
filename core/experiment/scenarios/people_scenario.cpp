// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/people_scenario.h"

#include "core/base/random.h"
#include "core/experiment/scenarios/random_draws.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dewpoint::experiment {
namespace {

using Eigen::Vector2d;
using simulation::Clothes;
using simulation::rgb;
using simulation::Vector3f;
using simulation::Walker;
using simulation::Waypoint;

constexpr double kAppear = 1.3; ///< seconds: the cameras have learned the empty room by then
/// Draws of ways before a scenario gives up.
constexpr int kMostDraws = 2000;

Vector2d heading(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// Where somebody can walk: not in the furniture, nor along the walls.
bool walkable(const Vector2d& position) {
  const double x = position.x();
  const double y = position.y();
  const bool desks = std::abs(x) > 1.6 && std::abs(y - std::copysign(0.9, x)) < 1.15;
  const bool partition = x < -0.9 && y < -1.1;
  return std::abs(x) < 2.6 && std::abs(y) < 2.6 && !desks && !partition;
}

bool walkable(const Walker& walker) {
  return std::ranges::all_of(walker.way,
                             [](const Waypoint& point) { return walkable(point.position); });
}

Vector3f colorOf(double hue, double saturation, double value) {
  // The usual conversion from hue (degrees), saturation and value.
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + hue / 60.0, 6.0);
    const double part = std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
    return static_cast<float>(255.0 * value * (1.0 - saturation * part));
  };
  return rgb(channel(5.0), channel(3.0), channel(1.0));
}

/// Trousers: dark, or of the color of the floor, so that legs fall apart in the masks.
Vector3f drawTrousers(Draws& draws) {
  static const std::array<Vector3f, 4> kUsual{rgb(58, 62, 84), rgb(70, 66, 62), rgb(104, 92, 74),
                                              rgb(132, 122, 106)};
  return kUsual.at(static_cast<std::size_t>(draws.uniform(0.0, 4.0)));
}

void dress(std::vector<Walker>& people, PeopleClothes clothes, Draws& draws) {
  double hue = draws.uniform(0.0, 360.0);
  const double saturation = draws.uniform(0.5, 0.75);
  const double value = draws.uniform(0.5, 0.8);
  const Vector3f trousers = drawTrousers(draws);
  for (Walker& person : people) {
    person.height = draws.uniform(1.62, 1.88);
    if (clothes == PeopleClothes::Different) {
      person.clothes.shirt = colorOf(hue, saturation, value);
      person.clothes.trousers = drawTrousers(draws);
      hue = std::fmod(hue + draws.uniform(100.0, 140.0), 360.0);
    } else {
      person.clothes.shirt = colorOf(std::fmod(hue + draws.uniform(-4.0, 4.0) + 360.0, 360.0),
                                     saturation, value * draws.uniform(0.97, 1.03));
      person.clothes.trousers = trousers;
    }
  }
}

Walker named(int number) {
  Walker walker;
  walker.name = fmt::format("person {}", number);
  walker.from = kAppear;
  return walker;
}

/// Two who walk past each other: nearest, 0.45 to 0.6 m, when both are in the middle.
void cross(PeopleScenario& scenario, Draws& draws) {
  constexpr double kHalf = 2.1; // seconds from the beginning to the nearest point
  const double nearest = kAppear + kHalf;
  const Vector2d middle(draws.uniform(-0.4, 0.4), draws.uniform(-0.4, 0.4));
  const double angle = draws.uniform(0.0, 2.0 * std::numbers::pi);
  const double turn = draws.uniform(1.2, std::numbers::pi);
  const std::array<Vector2d, 2> velocity{draws.uniform(0.85, 1.1) * heading(angle),
                                         draws.uniform(0.85, 1.1) * heading(angle + turn)};
  const Vector2d along = (velocity[1] - velocity[0]).normalized();
  const Vector2d gap = draws.uniform(0.45, 0.6) * Vector2d(-along.y(), along.x());
  for (int k = 0; k < 2; ++k) {
    Walker walker = named(k + 1);
    const Vector2d position = middle + (k == 0 ? -0.5 : 0.5) * gap;
    const Vector2d& pace = velocity.at(static_cast<std::size_t>(k));
    walker.way = {{kAppear, position - kHalf * pace}, {nearest + kHalf, position + kHalf * pace}};
    scenario.scene.people.push_back(walker);
  }
  scenario.before = nearest - 0.9;
  scenario.after = nearest + kHalf;
}

/// Two who come near each other, stand there, and go back.
void meet(PeopleScenario& scenario, Draws& draws) {
  const Vector2d middle(draws.uniform(-0.4, 0.4), draws.uniform(-0.4, 0.4));
  const Vector2d line = heading(draws.uniform(0.0, 2.0 * std::numbers::pi));
  const double gap = draws.uniform(0.5, 0.65);
  const double stay = draws.uniform(1.0, 2.0);
  const double reach = draws.uniform(1.6, 1.9);
  const double arrive = kAppear + reach / draws.uniform(0.9, 1.1);
  for (int k = 0; k < 2; ++k) {
    Walker walker = named(k + 1);
    const Vector2d way = (k == 0 ? -1.0 : 1.0) * line;
    // Not quite the way they came.
    const double aside = draws.uniform(-0.4, 0.4);
    const Vector2d back = reach * (way + aside * Vector2d(-way.y(), way.x()));
    walker.way = {{kAppear, middle + reach * way},
                  {arrive, middle + 0.5 * gap * way},
                  {arrive + stay, middle + 0.5 * gap * way},
                  {arrive + stay + reach, middle + back}};
    scenario.scene.people.push_back(walker);
  }
  scenario.before = arrive - 0.7;
  scenario.after = arrive + stay + reach;
}

/// Two who come together, walk side by side, and part.
void accompany(PeopleScenario& scenario, Draws& draws) {
  const Vector2d middle(draws.uniform(-0.3, 0.3), draws.uniform(-0.3, 0.3));
  const Vector2d along = heading(draws.uniform(0.0, 2.0 * std::numbers::pi));
  const Vector2d aside(-along.y(), along.x());
  const double gap = draws.uniform(0.5, 0.62);
  const double pace = draws.uniform(0.75, 0.95);
  const double together = 1.3; // meters before and after the middle
  const double join = kAppear + 1.2;
  const double part = join + 2.0 * together / pace;
  for (int k = 0; k < 2; ++k) {
    Walker walker = named(k + 1);
    const double side = k == 0 ? -1.0 : 1.0;
    const Vector2d near = 0.5 * side * gap * aside;
    const Vector2d far = draws.uniform(0.9, 1.2) * side * aside;
    walker.way = {{kAppear, middle - (together + 0.5) * along + far},
                  {join, middle - together * along + near},
                  {part, middle + together * along + near},
                  {part + 1.3, middle + (together + 0.5) * along + far}};
    scenario.scene.people.push_back(walker);
  }
  scenario.before = join - 0.6;
  scenario.after = part + 1.3;
}

/// Two who stay far from each other.
void stayApart(PeopleScenario& scenario, Draws& draws) {
  for (int k = 0; k < 2; ++k) {
    Walker walker = named(k + 1);
    const double side = k == 0 ? -1.0 : 1.0;
    walker.way = {{kAppear, {draws.uniform(-1.2, 1.2), side * draws.uniform(1.2, 1.6)}},
                  {kAppear + 4.0, {draws.uniform(-1.2, 1.2), side * draws.uniform(1.2, 1.6)}}};
    scenario.scene.people.push_back(walker);
  }
  scenario.before = kAppear + 1.0;
  scenario.after = kAppear + 4.0;
}

/// Three who come through doors, one after the other, and leave by others.
void visit(PeopleScenario& scenario, Draws& draws) {
  // Outside and inside of the four doors.
  static const std::array<std::array<Vector2d, 2>, 4> kDoors{
      {{Vector2d(-4.2, 1.3), Vector2d(-2.2, 0.8)},
       {Vector2d(4.2, -1.3), Vector2d(2.2, -0.8)},
       {Vector2d(0.05, 4.2), Vector2d(0.1, 2.2)},
       {Vector2d(0.6, -4.2), Vector2d(0.5, -2.2)}}};
  double start = kAppear;
  std::size_t door = static_cast<std::size_t>(draws.uniform(0.0, 4.0));
  for (int k = 0; k < 3; ++k) {
    Walker walker = named(k + 1);
    walker.from = -1.0;
    const auto& in = kDoors.at(door % 4);
    const auto& out = kDoors.at((door + 1 + static_cast<std::size_t>(draws.uniform(0.0, 3.0))) % 4);
    const double pace = draws.uniform(0.9, 1.2);
    const Vector2d inside(draws.uniform(-0.9, 0.9), draws.uniform(-0.9, 0.9));
    double time = start;
    walker.way.push_back({time, in[0]});
    for (const Vector2d& position : {in[1], inside, out[1], out[0]}) {
      time += (position - walker.way.back().position).norm() / pace;
      walker.way.push_back({time, position});
    }
    scenario.after = std::max(scenario.after, time + 1.5);
    scenario.scene.people.push_back(walker);
    start += draws.uniform(2.0, 3.0);
    door += 1;
  }
  scenario.before = 0.0;
}

struct Recipe {
  std::string name;
  std::string sentence;
  void (*draw)(PeopleScenario&, Draws&);
};

const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> all{
      {"crossing", "Two people walk past each other, 0.45 to 0.6 m apart.", cross},
      {"meet-and-turn", "Two people come within 0.5 to 0.65 m, stand, and go back.", meet},
      {"side-by-side", "Two people walk side by side, 0.5 to 0.62 m apart, and part.", accompany},
      {"enter-leave", "Three people come through doors, pass, and leave by others.", visit},
      {"apart", "Two people who stay far from each other.", stayApart},
  };
  return all;
}

/// Comes no nearer than two bodies can.
bool possible(const PeopleScenario& scenario, const std::string& name) {
  if (name == "enter-leave") {
    const auto& people = scenario.scene.people;
    for (double time = 0.0; time < scenario.after; time += 0.1) {
      for (std::size_t a = 0; a < people.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
          if ((people[a].position(time) - people[b].position(time)).norm() < 0.45) {
            return false;
          }
        }
      }
    }
    return true;
  }
  return std::ranges::all_of(scenario.scene.people,
                             [](const Walker& walker) { return walkable(walker); });
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

std::string peopleScenarioSentence(const std::string& name) {
  const auto found = std::ranges::find(recipes(), name, &Recipe::name);
  return found == recipes().end() ? std::string() : found->sentence;
}

Result<PeopleScenario> makePeopleScenario(const std::string& name, PeopleClothes clothes,
                                          std::uint64_t seed) {
  const auto found = std::ranges::find(recipes(), name, &Recipe::name);
  if (found == recipes().end()) {
    return failure(ErrorCode::NotFound, "", "scenario", name);
  }
  Draws draws(RandomStream(seed, 0, 0, RandomPurpose::Simulation));
  for (int k = 0; k < kMostDraws; ++k) {
    PeopleScenario scenario;
    found->draw(scenario, draws);
    if (possible(scenario, name)) {
      dress(scenario.scene.people, clothes, draws);
      scenario.scene.seed = seed;
      scenario.scene.frameCount =
          static_cast<std::int64_t>(scenario.after * scenario.scene.framesPerSecond) + 1;
      return scenario;
    }
  }
  return failure(ErrorCode::Undetermined, "", "scenario", name + ": no room for it");
}

} // namespace dewpoint::experiment
