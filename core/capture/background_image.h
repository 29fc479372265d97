// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/picture.h"

#include <opencv2/core/mat.hpp>

#include <string>

namespace dewpoint::capture {

/// What a camera shows when no target is there (CV_8UC3, rotated): the picture in a file, or the
/// median, pixel by pixel, of up to kBackgroundImagePictures evenly picked ones of a video or of a
/// folder of pictures. FileMissing, FileUnreadable or Mismatch name the file and the camera.
Result<cv::Mat> readBackgroundImage(const std::string& location, const PictureShape& camera);

/// Pictures that a median is taken of.
inline constexpr int kBackgroundImagePictures = 15;

} // namespace dewpoint::capture
