// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/people/people_wardrobe.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dewpoint::experiment {
namespace {

/// Heights of people of whom nothing else is said, meters: most adults.
constexpr double kLeastAdult = 1.62;
constexpr double kMostAdult = 1.88;

using simulation::ClothPattern;
using simulation::rgb;
using simulation::Vector3f;
using simulation::Walker;

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
Vector3f drawTrousers(RandomDraws& draws) {
  static const std::array<Vector3f, 4> kUsual{rgb(58, 62, 84), rgb(70, 66, 62), rgb(104, 92, 74),
                                              rgb(132, 122, 106)};
  return kUsual.at(static_cast<std::size_t>(draws.drawUniform(0.0, 4.0)));
}

/// Colors of the office in full light: walls, white and gray furniture, oak, partition, sofa,
/// floor.
Vector3f drawRoomColor(RandomDraws& draws) {
  static const std::array<Vector3f, 7> kRoom{
      rgb(226, 219, 203), rgb(214, 212, 206), rgb(148, 152, 158), rgb(186, 138, 88),
      rgb(112, 132, 150), rgb(74, 98, 128),   rgb(82, 73, 60)};
  const auto last = static_cast<int>(kRoom.size()) - 1;
  return kRoom.at(static_cast<std::size_t>(draws.drawInteger(0, last)));
}

Vector3f drawOtherRoomColor(const Vector3f& than, RandomDraws& draws) {
  Vector3f color = drawRoomColor(draws);
  while (color == than) {
    color = drawRoomColor(draws);
  }
  return color;
}

} // namespace

void dress(std::vector<Walker>& people, PeopleClothes clothes, RandomDraws& draws) {
  double hue = draws.drawUniform(0.0, 360.0);
  const double saturation = draws.drawUniform(0.5, 0.75);
  const double value = draws.drawUniform(0.5, 0.8);
  const Vector3f trousers = drawTrousers(draws);
  for (Walker& person : people) {
    person.height = draws.drawUniform(kLeastAdult, kMostAdult);
    if (clothes == PeopleClothes::Different) {
      person.clothes.shirt = colorOf(hue, saturation, value);
      person.clothes.trousers = drawTrousers(draws);
      hue = std::fmod(hue + draws.drawUniform(100.0, 140.0), 360.0);
    } else {
      person.clothes.shirt = colorOf(std::fmod(hue + draws.drawUniform(-4.0, 4.0) + 360.0, 360.0),
                                     saturation, value * draws.drawUniform(0.97, 1.03));
      person.clothes.trousers = trousers;
    }
  }
}

void dressLikeTheRoom(PeopleScenario& scenario, PeopleClothes clothes, RandomDraws& draws) {
  Vector3f shirt = drawRoomColor(draws);
  Vector3f trousers = drawRoomColor(draws);
  for (Walker& person : scenario.scene.people) {
    person.clothes.shirt = shirt;
    person.clothes.trousers = trousers;
    if (clothes == PeopleClothes::Different) {
      shirt = drawOtherRoomColor(shirt, draws);
      trousers = drawRoomColor(draws);
    }
  }
}

void dressInPatterns(PeopleScenario& scenario, PeopleClothes clothes, RandomDraws& draws) {
  static constexpr std::array<ClothPattern, 3> kPatterns{
      ClothPattern::Stripes, ClothPattern::Checks, ClothPattern::Blotches};
  std::vector<Walker>& people = scenario.scene.people;
  simulation::Cloth cloth;
  for (std::size_t k = 0; k < people.size(); ++k) {
    if (k == 0 || clothes == PeopleClothes::Different) {
      cloth.pattern = kPatterns.at(static_cast<std::size_t>(draws.drawInteger(0, 2)));
      const double hue = draws.drawUniform(0.0, 360.0);
      const double saturation = draws.drawUniform(0.0, 0.7);
      cloth.secondColor = colorOf(hue, saturation, draws.drawUniform(0.15, 0.95));
      cloth.patternWidth = static_cast<float>(draws.drawUniform(0.04, 0.12)); // meters
    }
    people[k].clothes.shirtCloth = cloth;
  }
}

} // namespace dewpoint::experiment
