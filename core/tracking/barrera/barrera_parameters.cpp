// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/barrera/barrera_parameters.h"

#include "core/tracking/start_parameters.h"

#include <vector>

namespace dewpoint::tracking {
namespace {

std::vector<ParameterDeclaration> declareBarrera() {
  std::vector<ParameterDeclaration> all{
      {"particles", ParameterKind::Integer, "Particles", "", 10.0, 1000000.0, 10.0, 200.0,
       "Number of particles of the filter: more particles track more reliably, but take more time.",
       true},
      {"motion_sigma", ParameterKind::Real, "Motion sigma", "m", 0.001, 0.5, 0.001, 0.03,
       "How far particles move at random along each axis in one iteration: larger values follow "
       "faster objects, but spread the particles wider.",
       true},
      {"iterations_per_frame", ParameterKind::Integer, "Iterations per frame", "", 1.0, 500.0, 1.0,
       1.0, "How many filter iterations run on each frame.", false},
  };
  const auto start = startParameters({{0.4, 0.1, 0.2}, {0.0, 0.0, 0.0}}); // the paper's
  all.insert(all.end(), start.begin(), start.end());
  return all;
}

} // namespace

std::span<const ParameterDeclaration> barreraParameters() {
  static const std::vector<ParameterDeclaration> declarations = declareBarrera();
  return declarations;
}

} // namespace dewpoint::tracking
