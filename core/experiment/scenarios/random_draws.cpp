// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/random_draws.h"

#include <cmath>

namespace dewpoint::experiment {

std::uint32_t hashOf(const std::string& text) {
  // FNV-1a, 32 bits.
  std::uint32_t hash = 2166136261U;
  for (const char letter : text) {
    hash = (hash ^ static_cast<std::uint8_t>(letter)) * 16777619U;
  }
  return hash;
}

RandomDraws::RandomDraws(std::uint64_t seed, const std::string& name)
    : stream_(derivedSeed(seed, hashOf(name)), 0, 0, RandomPurpose::Start) {}

double RandomDraws::drawUniform(double low, double high) {
  return low + (high - low) * stream_.uniform(next_++);
}

double RandomDraws::drawNormal(double sigma) {
  return sigma * stream_.normal4(next_++)[0];
}

int RandomDraws::drawInteger(int low, int high) {
  return low + static_cast<int>(std::floor(drawUniform(0.0, high - low + 1.0)));
}

Eigen::Vector3d RandomDraws::drawPointInBox(const Eigen::Vector3d& low,
                                            const Eigen::Vector3d& high) {
  const double x = drawUniform(low.x(), high.x());
  const double y = drawUniform(low.y(), high.y());
  return {x, y, drawUniform(low.z(), high.z())};
}

Eigen::Vector3d RandomDraws::drawDirection() {
  const double z = drawUniform(-1.0, 1.0);
  const double angle = drawUniform(0.0, kFullTurn);
  const double flat = std::sqrt(1.0 - z * z);
  return {flat * std::cos(angle), flat * std::sin(angle), z};
}

} // namespace dewpoint::experiment
