// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/random.h"

#include <Eigen/Core>

#include <cstdint>
#include <numbers>
#include <string>

namespace dewpoint::experiment {

/// Returns the hash of a string, which is the same on every platform (FNV-1a).
std::uint32_t hashOf(const std::string& text);

inline constexpr double kFullTurn = 2.0 * std::numbers::pi; ///< radians

/// Sequence of random numbers for building a scenario, determined by a seed.
class RandomDraws {
public:
  explicit RandomDraws(const RandomStream& stream) : stream_(stream) {}
  /// Starts the random sequence for a seed and a name, for example the name of a scenario.
  /// Different names have independent sequences.
  RandomDraws(std::uint64_t seed, const std::string& name);

  double drawUniform(double low, double high);
  double drawNormal(double sigma);
  int drawInteger(int low, int high); ///< random integer from low to high, both included
  bool flipCoin() { return drawInteger(0, 1) == 1; }
  Eigen::Vector3d drawPointInBox(const Eigen::Vector3d& low, const Eigen::Vector3d& high);
  Eigen::Vector3d drawDirection(); ///< random unit vector, uniform over the sphere

private:
  RandomStream stream_;
  std::uint32_t next_ = 0;
};

} // namespace dewpoint::experiment
