// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/formats/calibration_format.h"

namespace dewpoint::calibration {

/// Returns the format of scripts that write what OpenCV's functions return: JSON or YAML with a
/// camera matrix and distortion coefficients for each camera. A rotation and a translation from
/// world to camera are optional. A file contains one camera, a list of cameras, or cameras under
/// their names. The keys are:
/// - K, camera_matrix, intrinsic_matrix, mtx or matrix: 3x3, row by row;
/// - dist, distortion, distortion_coefficients, dist_coeffs or D: none if absent;
/// - R, rotation, rotation_matrix (3x3 or a rotation vector, radians), rvec or rotation_vector;
/// - t, T, tvec, translation or translation_vector;
/// - image_size, size or resolution: [width, height]; or the two keys width and height, or
///   image_width and image_height;
/// - optionally name, unit (see parseLengthUnit()) and model: fisheye.
CalibrationFormat plainFormat();

/// Returns whether a text has a rotation and a translation under keys such as R and t, which
/// scripts use (plainFormat()). Files from OpenCV's samples do not have these keys next to a camera
/// matrix.
bool hasPlainPose(const std::string& text);

} // namespace dewpoint::calibration
