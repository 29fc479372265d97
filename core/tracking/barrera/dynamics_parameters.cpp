// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/barrera/dynamics_parameters.h"

#include "core/tracking/barrera/barrera_parameters.h"

#include <vector>

namespace dewpoint::tracking {
namespace {

std::vector<ParameterDeclaration> declareDynamics() {
  const auto walk = barreraParameters();
  std::vector<ParameterDeclaration> all(walk.begin(), walk.end());
  all.insert(all.begin() + 2, {"observation_sigma", ParameterKind::Real, "Observation sigma", "m",
                               0.001, 5.0, 0.001, 0.1,
                               "Assumed error of a measured position along each axis: larger "
                               "values trust the particles more, smaller values the measurement.",
                               true});
  putInGroup(ParameterGroup::Expert, {"iterations_per_frame"}, all);
  return all;
}

} // namespace

std::span<const ParameterDeclaration> dynamicsParameters() {
  static const std::vector<ParameterDeclaration> declarations = declareDynamics();
  return declarations;
}

} // namespace dewpoint::tracking
