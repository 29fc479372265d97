// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// Camera whose lens is expressed in the coefficients of a format.
struct LensRefit {
  Camera camera;
  bool isRefitted = false; ///< false if the format can represent the lens as it is
  /// Largest distance between the pixels to which the original and the new lens project a
  /// direction; infinite if the new lens has no pixel for one of the directions.
  double maxDifferencePx = 0.0;
  double rmsDifferencePx = 0.0;
};

/// Returns whether a format with the lens models `range` can represent the lens of this camera
/// exactly.
bool isLensSupported(const Camera& camera, const LensSupport& range);

/// Fits a camera's lens to the coefficients of a format. If the format can represent the lens
/// exactly, returns the camera unchanged. Otherwise fits the focal lengths, the principal point and
/// the coefficients that `range` allows, so that the same directions are projected to nearly the
/// same pixels. Method: least squares over 33 x 33 pixels in the image (Levenberg-Marquardt). The
/// pose is unchanged. A fisheye lens becomes a pinhole lens if `range` has no fisheye model; pixels
/// at 85 degrees or more from the optical axis are then ignored.
LensRefit refitLens(const Camera& camera, const LensSupport& range);

} // namespace dewpoint::calibration
