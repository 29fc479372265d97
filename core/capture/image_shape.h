// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <opencv2/core/mat.hpp>

#include <string>

namespace dewpoint::capture {

/// Required shape for all images of a camera, and the camera's name for error messages.
struct ImageShape {
  std::string camera;
  int rotateDegrees = 0; ///< clockwise: 0, 90, 180 or 270
  int width = 0;         ///< after the rotation, pixels; 0: any
  int height = 0;        ///< after the rotation, pixels; 0: any
  bool mirrored = false; ///< left and right are swapped after the rotation
};

/// Returns the name of a camera for error messages: "camera 'left'", but not "camera 'camera 1'".
std::string cameraField(const std::string& name);

/// Checks that the rotation is 0, 90, 180 or 270 degrees and that the size is not negative.
Status checkShape(const ImageShape& shape, const std::string& file);

/// Converts an image to CV_8UC3 (from gray or BGRA if needed), rotates and mirrors it, and checks
/// its size. If no change was needed, the result shares the pixels of `picture`.
Result<cv::Mat> prepareImage(const cv::Mat& picture, const ImageShape& shape,
                             const std::string& file);

} // namespace dewpoint::capture
