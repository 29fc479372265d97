// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/barrera_parameters.h"

#include <string>
#include <vector>

namespace dewpoint {
namespace {

ParameterDeclaration startCoordinate(const std::string& axis, double defaultValue) {
  return {"start_" + axis,
          ParameterKind::Real,
          "Start " + axis,
          "m",
          -100.0,
          100.0,
          0.01,
          defaultValue,
          "World " + axis + " of the place where all particles start.",
          false};
}

ParameterDeclaration startHalfSize(const std::string& axis) {
  return {"start_half_" + axis,
          ParameterKind::Real,
          "Start half-size " + axis,
          "m",
          0.0,
          50.0,
          0.01,
          0.0,
          "Half the " + axis +
              " size of the box around the start in which particles start evenly spread; 0 starts "
              "them all at the same " +
              axis + ".",
          false};
}

std::vector<ParameterDeclaration> declare() {
  return {
      {"particles", ParameterKind::Integer, "Particles", "", 10.0, 1000000.0, 10.0, 200.0,
       "How many particles the filter uses: more follow more surely and cost more time.", true},
      {"motion_sigma", ParameterKind::Real, "Motion sigma", "m", 0.001, 0.5, 0.001, 0.03,
       "How far particles move at random along each axis in one iteration: larger follows faster "
       "objects and spreads wider.",
       true},
      {"iterations_per_frame", ParameterKind::Integer, "Iterations per frame", "", 1.0, 500.0, 1.0,
       1.0, "How many filter iterations run on each frame.", false},
      startCoordinate("x", 0.4),
      startCoordinate("y", 0.1),
      startCoordinate("z", 0.2),
      startHalfSize("x"),
      startHalfSize("y"),
      startHalfSize("z"),
  };
}

} // namespace

std::span<const ParameterDeclaration> barreraParameters() {
  static const std::vector<ParameterDeclaration> declarations = declare();
  return declarations;
}

} // namespace dewpoint
