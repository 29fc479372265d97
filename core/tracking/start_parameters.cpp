// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/start_parameters.h"

#include <array>
#include <cstddef>
#include <string>

namespace dewpoint::tracking {
namespace {

const std::array<std::string, 3> kAxes{"x", "y", "z"};

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

ParameterDeclaration startHalfSize(const std::string& axis, double defaultValue) {
  return {"start_half_" + axis,
          ParameterKind::Real,
          "Start half-size " + axis,
          "m",
          0.0,
          50.0,
          0.01,
          defaultValue,
          "Half the " + axis +
              " size of the box around the start in which particles start evenly spread; 0 starts "
              "them all at the same " +
              axis + ".",
          false};
}

} // namespace

std::vector<ParameterDeclaration> startParameters(const StartVolume& defaults) {
  std::vector<ParameterDeclaration> all;
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    all.push_back(startCoordinate(kAxes[axis], defaults.center[static_cast<Eigen::Index>(axis)]));
  }
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    all.push_back(startHalfSize(kAxes[axis], defaults.half[static_cast<Eigen::Index>(axis)]));
  }
  return all;
}

StartVolume startVolume(const ParameterValues& parameters) {
  StartVolume volume;
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    const auto at = static_cast<Eigen::Index>(axis);
    volume.center[at] = parameters.at("start_" + kAxes[axis]);
    volume.half[at] = parameters.at("start_half_" + kAxes[axis]);
  }
  return volume;
}

Eigen::ArrayXXd drawUniformly(const StartVolume& volume, Eigen::Index count,
                              const RandomStream& stream) {
  Eigen::ArrayXXd positions(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto unit = stream.uniform3(static_cast<std::uint32_t>(i));
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      positions(i, axis) = volume.center[axis] +
                           volume.half[axis] * (2.0 * unit[static_cast<std::size_t>(axis)] - 1.0);
    }
  }
  return positions;
}

} // namespace dewpoint::tracking
