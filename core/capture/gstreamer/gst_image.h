// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core/mat.hpp>

#include <string>

struct _GstSample; // NOLINT(bugprone-reserved-identifier): the library's

namespace dewpoint::capture {

/// Returns the media type of a sample, such as video/x-raw or image/jpeg; empty if it has none.
std::string mediaTypeOf(_GstSample& sample);

/// Returns the media type, size and format of a sample as text. Only samples with the same text can
/// be stored in one file.
std::string storedFormatOf(_GstSample& sample);

/// Returns a copy of a raw image of any format as CV_8UC3 (blue, green, red). The result is empty
/// if the sample is not a raw image, or if it has too few bytes for its size.
cv::Mat imageOf(_GstSample& sample);

/// Returns a new sample with a copy of an image (CV_8UC3) and without a time stamp. The caller owns
/// the sample.
_GstSample* sampleOf(const cv::Mat& image);

} // namespace dewpoint::capture
