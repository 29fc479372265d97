// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/surface/solid.h"

#include <vector>

namespace dewpoint::simulation {

/// Patch of another color on a surface. The patch covers the points at which the angle between the
/// surface normal and `axis` is below a limit. On a ball, the patch is a spherical cap.
struct SurfacePatch {
  Vector3f axis{0.0F, 0.0F, 1.0F};  ///< unit vector in the body's own axes
  float maxAngleCosine = 1.0F;      ///< cosine of the limit of the angle; 0: half of the ball
  Vector3f color{0.0F, 0.0F, 0.0F}; ///< BGR in full light, [0, 255]
};

/// Band of another color around a great circle.
struct SurfaceSeam {
  Vector3f axis{0.0F, 0.0F, 1.0F}; ///< axis of the circle; unit vector in the body's own axes
  float maxAngleSine =
      0.0F; ///< sine of the largest angle between the band and the plane of the circle
  Vector3f color{0.0F, 0.0F, 0.0F};
};

/// Pattern painted on a surface in addition to its color. Where patches and seams overlap, patches
/// are visible. Where patches overlap, the first patch in `patches` is visible.
struct SurfacePattern {
  std::vector<SurfacePatch> patches;
  std::vector<SurfaceSeam> seams;

  /// Returns the color where the surface normal is `normal` (unit vector in the body's own axes).
  /// Returns `plain` where nothing is painted.
  Vector3f colorAt(const Vector3f& normal, const Vector3f& plain) const;
};

/// Reflection of the lamp on a surface (Blinn, SIGGRAPH 1977). The reflection adds white light of
/// peakLevel * cos(a)^exponent gray levels, where a is the angle between the surface normal and the
/// bisector of the directions to lamp and camera. The highlight is clipped where the sum reaches
/// 255.
struct Gloss {
  float peakLevel = 0.0F;
  float exponent = 12.0F;

  /// Returns the gray levels of the highlight. All vectors are unit vectors; `direction` is from
  /// the camera to the surface.
  float highlightAt(const Vector3f& normal, const Vector3f& towardsLamp,
                    const Vector3f& direction) const;
};

/// Gloss of plain balls. Chosen to look like rubber, on which the reflection of the lamp is barely
/// visible.
inline constexpr Gloss kBallGloss{12.0F, 12.0F};

} // namespace dewpoint::simulation
