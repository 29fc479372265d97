// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/boxes/sugandi_parameters.h"

#include <vector>

namespace dewpoint::tracking {
namespace {

std::vector<ParameterDeclaration> declareSugandi() {
  return {
      {"particles", ParameterKind::Integer, "Particles", "", 10.0, 100000.0, 10.0, 300.0,
       "Number of particles of the filter: more particles track more reliably, but take more time.",
       true},
      {"position_sigma", ParameterKind::Real, "Position sigma", "px", 0.1, 200.0, 0.1, 10.0,
       "How far particles move at random along each axis between images, in addition to their "
       "constant velocity: larger values follow sudden motion, but spread the particles wider.",
       true},
      {"likelihood_sigma", ParameterKind::Real, "Likelihood sigma", "", 0.01, 1.0, 0.01, 0.1,
       "How much the colors of a particle's box may differ from the reference colors "
       "(Bhattacharyya distance): smaller values trust the best particles more.",
       true},
  };
}

} // namespace

std::span<const ParameterDeclaration> sugandiParameters() {
  static const std::vector<ParameterDeclaration> declarations = declareSugandi();
  return declarations;
}

} // namespace dewpoint::tracking
