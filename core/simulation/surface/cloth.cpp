// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/surface/cloth.h"

#include "core/simulation/surface/texture.h"

#include <cmath>

namespace dewpoint::simulation {
namespace {

/// Number of the field of `width` meters that a coordinate lies in.
int fieldOf(float coordinate, float width) {
  return static_cast<int>(std::floor(coordinate / width));
}

bool isOdd(int number) {
  return number % 2 != 0;
}

} // namespace

Vector3f clothColor(const Cloth& cloth, const Vector3f& first, const Vector3f& position) {
  bool second = false;
  switch (cloth.pattern) {
  case ClothPattern::Plain:
    break;
  case ClothPattern::Stripes:
    second = isOdd(fieldOf(position.z(), cloth.patternWidth));
    break;
  case ClothPattern::Checks:
    second = isOdd(fieldOf(position.x(), cloth.patternWidth) +
                   fieldOf(position.y(), cloth.patternWidth) +
                   fieldOf(position.z(), cloth.patternWidth));
    break;
  case ClothPattern::Blotches:
    second = valueNoise(position / cloth.patternWidth) > 0.0F;
    break;
  }
  return second ? cloth.secondColor : first;
}

} // namespace dewpoint::simulation
