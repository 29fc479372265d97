// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// A camera with its lens expressed in the coefficients of a format.
struct LensRefit {
  Camera camera;
  bool refitted = false;      ///< false: the format can describe the lens as it is
  double largestPixels = 0.0; ///< over the sampled image; infinite if a direction has no pixel
  double rootMeanSquarePixels = 0.0;
};

/// Returns true if the format's coefficients can describe this lens exactly.
bool fits(const Camera& camera, const LensRange& range);

/// Fits a camera's lens to the coefficients of a format. If the lens fits already, returns the
/// camera itself; otherwise focal lengths, principal point and the coefficients of `range` that
/// project the same directions to nearly the same pixels: least squares over 33 x 33 pixels of the
/// image (Levenberg and Marquardt's method). The pose is unchanged. A fisheye lens becomes a
/// pinhole lens if the range has no fisheye model; pixels 85 degrees or more off its axis are then
/// ignored.
LensRefit refitLens(const Camera& camera, const LensRange& range);

} // namespace dewpoint::calibration
