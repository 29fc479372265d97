// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core/mat.hpp>

#include <string>

struct _GstSample; // NOLINT(bugprone-reserved-identifier): the library's

namespace dewpoint::capture {

/// Returns the media type of a sample, such as video/x-raw or image/jpeg; empty if it has none.
std::string mediaTypeOf(_GstSample& sample);

/// Returns what has to stay the same for all images of one file: media type, size and format.
std::string storedFormatOf(_GstSample& sample);

/// Returns a copy of a raw image of any format as CV_8UC3 (blue, green, red); empty if the sample
/// is not a raw image, or too short for its size.
cv::Mat imageOf(_GstSample& sample);

/// Makes a sample with a copy of an image (CV_8UC3), without a time stamp. The caller owns it.
_GstSample* sampleOf(const cv::Mat& image);

} // namespace dewpoint::capture
