// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/geometry/image_margins.h"

#include <opencv2/core/mat.hpp>

#include <string>

namespace dewpoint::capture {

/// Rotation, mirroring, cropping and final size of the images of a camera, and the camera's name
/// for error messages.
struct ImageShape {
  std::string cameraName;
  int rotateDegrees = 0;   ///< clockwise rotation of the images: 0, 90, 180 or 270 degrees
  int width = 0;           ///< width after rotation and cropping, pixels; 0: any
  int height = 0;          ///< height after rotation and cropping, pixels; 0: any
  bool isMirrored = false; ///< true if left and right are swapped after the rotation
  ImageMargins crop = {};  ///< margins that are cut off after rotation and mirroring
};

/// Returns the name of a camera in quotation marks for error messages. The word "camera" is put
/// before a name that does not begin with it: "camera 'left'", "'camera 1'".
std::string quotedCameraName(const std::string& name);

/// Checks that the rotation is 0, 90, 180 or 270 degrees, and that neither the size nor a margin is
/// negative. `file` is the file to name in the error.
Status checkShape(const ImageShape& shape, const std::string& file);

/// Returns an image as CV_8UC3 (converted from gray or BGRA if needed), rotated, mirrored and
/// cropped as `shape` requires. If no change was needed, the result shares the pixels of `picture`.
/// Fails if the image does not have the size of `shape`; `file` is the file to name in the error.
Result<cv::Mat> prepareImage(const cv::Mat& picture, const ImageShape& shape,
                             const std::string& file);

} // namespace dewpoint::capture
