// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// Camera whose lens is expressed in the coefficients of a format.
struct LensRefit {
  Camera camera;
  bool refitted = false; ///< false if the format can represent the lens as it is
  double largestPixels =
      0.0; ///< largest error over the sampled image, pixels; infinite if a direction has no pixel
  double rootMeanSquarePixels = 0.0;
};

/// Returns whether the format's coefficients can represent this lens exactly.
bool fits(const Camera& camera, const LensSupport& range);

/// Fits a camera's lens to the coefficients of a format. If the format can represent the lens
/// exactly, returns the camera unchanged. Otherwise finds the focal lengths, principal point and
/// coefficients of `range` that project the same directions to nearly the same pixels: least
/// squares over 33 x 33 pixels in the image (Levenberg-Marquardt). The pose is unchanged. A fisheye
/// lens becomes a pinhole lens if the range has no fisheye model; pixels 85 degrees or more off its
/// axis are then ignored.
LensRefit refitLens(const Camera& camera, const LensSupport& range);

} // namespace dewpoint::calibration
