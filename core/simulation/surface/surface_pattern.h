// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/surface/solid.h"

#include <vector>

namespace dewpoint::simulation {

/// A patch of another color: where the surface's normal is within an angle of an axis. On a ball
/// that is a spherical cap.
struct SurfacePatch {
  Vector3f axis{0.0F, 0.0F, 1.0F};  ///< unit vector in the body's own axes
  float cosine = 1.0F;              ///< of the greatest angle; 0: half of the ball
  Vector3f color{0.0F, 0.0F, 0.0F}; ///< BGR in full light, [0, 255]
};

/// A band of another color around a great circle.
struct SurfaceSeam {
  Vector3f axis{0.0F, 0.0F, 1.0F}; ///< of the circle; unit vector in the body's own axes
  float sine = 0.0F;               ///< of the greatest angle to the circle's plane
  Vector3f color{0.0F, 0.0F, 0.0F};
};

/// What is painted on a surface beside its color. The patches lie over the seams, and the first
/// patch over the others.
struct SurfacePattern {
  std::vector<SurfacePatch> patches;
  std::vector<SurfaceSeam> seams;

  /// The color where the normal is `normal` (unit vector, the body's own axes); `plain` where
  /// nothing is painted.
  Vector3f colorAt(const Vector3f& normal, const Vector3f& plain) const;
};

/// How a surface mirrors the lamp: white light of `peak` gray levels times cos^power of the angle
/// between the normal and the half way between lamp and camera (Blinn, SIGGRAPH 1977). Where the
/// sum reaches 255 the highlight is clipped.
struct Gloss {
  float peak = 0.0F;
  float power = 12.0F;

  float at(const Vector3f& normal, const Vector3f& towardsLamp, const Vector3f& direction) const;
};

/// That of the plain balls; chosen: rubber, on which one just sees where the lamp is.
inline constexpr Gloss kBallGloss{12.0F, 12.0F};

} // namespace dewpoint::simulation
