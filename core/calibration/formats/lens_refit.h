// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// A camera's lens in the coefficients that a format has.
struct LensRefit {
  Camera camera;
  bool refitted = false;      ///< false: the lens fits as it is
  double largestPixels = 0.0; ///< over the sampled image, infinite where a direction has no pixel
  double rootMeanSquarePixels = 0.0;
};

/// True when the format's coefficients can describe this lens without any loss.
bool fits(const Camera& camera, const LensRange& range);

/// The camera itself where it fits; else focal lengths, principal point and the coefficients of
/// `range` that see the same directions at nearly the same pixels: least squares over 33 x 33
/// pixels of the image (Levenberg and Marquardt's method). The pose stays. A fisheye becomes a
/// pinhole where the range has none; pixels at which it looks 85 degrees or more off its axis are
/// left out then.
LensRefit refitLens(const Camera& camera, const LensRange& range);

} // namespace dewpoint::calibration
