// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace dewpoint::capture {

/// An image (CV_8UC3) in memory that is not ours, without a copy of its pixels: `owner` is released
/// with the last cv::Mat that shows them, in whatever thread that is. `stride`: bytes from one row
/// to the next, at least 3 * width. Nobody may write the pixels as long as they are shown.
cv::Mat borrowedImage(int width, int height, std::uint8_t* pixels, std::size_t stride,
                      std::shared_ptr<void> owner);

} // namespace dewpoint::capture
