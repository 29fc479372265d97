// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/start_parameters.h"

#include "core/base/units.h"
#include "core/geometry/seen_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace dewpoint::tracking {
namespace {

const std::array<std::string, 3> kAxes{"x", "y", "z"};

ParameterDeclaration startCoordinate(const std::string& axis, double defaultValue) {
  return {"start_" + axis,
          ParameterKind::Real,
          "Start box, center " + axis,
          "m",
          -100.0,
          100.0,
          0.01,
          defaultValue,
          "World " + axis + " coordinate of the center of the box in which the particles start.",
          false,
          true,
          ParameterGroup::Start};
}

ParameterDeclaration startHalfSize(const std::string& axis, double defaultValue) {
  return {"start_half_" + axis,
          ParameterKind::Real,
          "Start box, half width " + axis,
          "m",
          0.0,
          50.0,
          0.01,
          defaultValue,
          "Half the " + axis +
              " size of the start box: the particles start evenly spread in this box; 0 starts "
              "them all at the same " +
              axis + ".",
          false,
          true,
          ParameterGroup::Start};
}

bool isAnyStartGiven(const ParameterValues& parameters) {
  return std::ranges::any_of(parameters.declarations(), [&](const auto& declaration) {
    return declaration.isDerivedFromCameras && declaration.key.starts_with("start_") &&
           parameters.isGiven(declaration.key);
  });
}

/// The box in which a method looks for targets that nobody placed.
std::optional<StartVolume> startFromCameras(const CameraRig& rig,
                                            const std::optional<WorldBox>& volumeOfInterest) {
  const auto seen = seenVolume(rig);
  if (!seen) {
    return volumeOfInterest ? std::optional(StartVolume{volumeOfInterest->center(),
                                                        volumeOfInterest->halfSize()})
                            : std::nullopt;
  }
  const StartVolume start{seen->center(), seen->halfSize()};
  return volumeOfInterest ? startVolumeWithin(start, *volumeOfInterest) : start;
}

/// The values of a start volume under their keys, and the search size that goes with it. Halves and
/// the size are rounded up, so that they take in the volume.
ParameterValues::ValuesByKey valuesOf(const StartVolume& start) {
  // In steps of the declarations: a centimeter, and a decimeter of the search size.
  const auto centimeters = [](double value) { return std::round(inCentimeters(value)) / 100.0; };
  ParameterValues::ValuesByKey values;
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    const auto at = static_cast<Eigen::Index>(axis);
    values["start_" + kAxes[axis]] = centimeters(start.center[at]);
    values["start_half_" + kAxes[axis]] = std::ceil(inCentimeters(start.halfSize[at])) / 100.0;
  }
  values[kSearchSizeKey] = std::ceil(10.0 * 2.0 * start.halfSize.maxCoeff()) / 10.0;
  return values;
}

} // namespace

std::vector<ParameterDeclaration> startParameters(const StartVolume& defaults) {
  std::vector<ParameterDeclaration> all;
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    all.push_back(startCoordinate(kAxes[axis], defaults.center[static_cast<Eigen::Index>(axis)]));
  }
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    all.push_back(startHalfSize(kAxes[axis], defaults.halfSize[static_cast<Eigen::Index>(axis)]));
  }
  return all;
}

StartVolume startVolumeOf(const ParameterValues& parameters) {
  StartVolume volume;
  for (std::size_t axis = 0; axis < kAxes.size(); ++axis) {
    const auto at = static_cast<Eigen::Index>(axis);
    volume.center[at] = parameters.at("start_" + kAxes[axis]);
    volume.halfSize[at] = parameters.at("start_half_" + kAxes[axis]);
  }
  return volume;
}

StartVolume startVolumeWithin(const StartVolume& start, const WorldBox& box) {
  const Eigen::Vector3d low = (start.center - start.halfSize).cwiseMax(box.min);
  const Eigen::Vector3d high = (start.center + start.halfSize).cwiseMin(box.max);
  const bool apart = (low.array() > high.array()).any();
  const WorldBox common = apart ? box : WorldBox{low, high};
  return {common.center(), common.halfSize()};
}

ParameterValues effectiveParameters(ParameterValues parameters, const CameraRig& rig,
                                    const std::optional<WorldBox>& volumeOfInterest) {
  const bool isOpen = std::ranges::any_of(parameters.declarations(), [&](const auto& declaration) {
    return !parameters.isGiven(declaration.key);
  });
  const auto start = isOpen && !isAnyStartGiven(parameters)
                         ? startFromCameras(rig, volumeOfInterest)
                         : std::nullopt;
  parameters.setDerivedValues(start ? valuesOf(*start) : ParameterValues::ValuesByKey{});
  return parameters;
}

Eigen::ArrayXXd drawUniformPositions(const StartVolume& volume, Eigen::Index count,
                                     const RandomStream& stream) {
  Eigen::ArrayXXd positions(count, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto unit = stream.uniform3(static_cast<std::uint32_t>(i));
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      positions(i, axis) =
          volume.center[axis] +
          volume.halfSize[axis] * (2.0 * unit[static_cast<std::size_t>(axis)] - 1.0);
    }
  }
  return positions;
}

} // namespace dewpoint::tracking
