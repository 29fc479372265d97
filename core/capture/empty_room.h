// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/picture.h"

#include <opencv2/core/mat.hpp>

#include <string>

namespace dewpoint::capture {

/// Background image of a camera (CV_8UC3, rotated): the image in a file, or the pixelwise median of
/// up to kEmptyRoomPictures images picked evenly from a video or a folder. The errors FileMissing,
/// FileUnreadable and Mismatch name the file and the camera.
Result<cv::Mat> readEmptyRoom(const std::string& location, const PictureShape& camera);

/// Maximum number of images of which the median is computed.
inline constexpr int kEmptyRoomPictures = 15;

} // namespace dewpoint::capture
