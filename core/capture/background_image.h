// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/image_shape.h"

#include <opencv2/core/mat.hpp>

#include <string>

namespace dewpoint::capture {

/// Reads the background image of a camera, which shows the scene without targets. The result is
/// CV_8UC3, rotated, mirrored and cropped as `camera` specifies. `location` is an image file, a
/// video or a folder of images. For a video or folder, the result is the pixel-by-pixel median of
/// up to kMaxMedianImages evenly spaced images. Errors: FileMissing, FileUnreadable and Mismatch.
/// They name the file and the camera.
Result<cv::Mat> readBackgroundImage(const std::string& location, const ImageShape& camera);

/// Maximum number of images from which the median is computed.
inline constexpr int kMaxMedianImages = 15;

} // namespace dewpoint::capture
