// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <opencv2/core/mat.hpp>

#include <string>

namespace dewpoint::capture {

/// What every picture of one camera has to be, and whom to name when it is not.
struct PictureShape {
  std::string camera;
  int rotateDegrees = 0; ///< clockwise: 0, 90, 180 or 270
  int width = 0;         ///< after the rotation, pixels; 0: any
  int height = 0;        ///< after the rotation, pixels; 0: any
  bool mirrored = false; ///< left to right, after the rotation
};

/// How errors name a camera: "camera 'left'", but not "camera 'camera 1'".
std::string cameraField(const std::string& name);

/// Whether the rotation is one of 0, 90, 180 and 270 degrees and the size is not negative.
Status checkShape(const PictureShape& shape, const std::string& file);

/// The picture as CV_8UC3, rotated and mirrored, and of the requested size; gray and BGRA are
/// converted. The result shares the pixels of `picture` when nothing had to change.
Result<cv::Mat> shaped(const cv::Mat& picture, const PictureShape& shape, const std::string& file);

} // namespace dewpoint::capture
