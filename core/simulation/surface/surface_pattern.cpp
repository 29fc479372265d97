// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/surface/surface_pattern.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::simulation {

Vector3f SurfacePattern::colorAt(const Vector3f& normal, const Vector3f& plain) const {
  const auto onPatch = std::ranges::find_if(patches, [&](const SurfacePatch& patch) {
    return patch.axis.dot(normal) >= patch.maxAngleCosine;
  });
  if (onPatch != patches.end()) {
    return onPatch->color;
  }
  const auto onSeam = std::ranges::find_if(seams, [&](const SurfaceSeam& seam) {
    return std::abs(seam.axis.dot(normal)) <= seam.maxAngleSine;
  });
  return onSeam != seams.end() ? onSeam->color : plain;
}

float Gloss::highlightAt(const Vector3f& normal, const Vector3f& towardsLamp,
                         const Vector3f& direction) const {
  if (peakLevel <= 0.0F) {
    return 0.0F;
  }
  const Vector3f halfway = (towardsLamp - direction).normalized();
  return peakLevel * std::pow(std::max(0.0F, normal.dot(halfway)), exponent);
}

} // namespace dewpoint::simulation
