// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>

namespace dewpoint::capture {

/// Returns an image (CV_8UC3) that uses pixels owned by `owner`, without copying them. `owner` is
/// released together with the last cv::Mat that uses the pixels. This may happen in any thread.
/// `stride` is the distance between rows in bytes, at least 3 * width. The pixels must not be
/// modified while an image uses them.
cv::Mat borrowedImage(int width, int height, std::uint8_t* pixels, std::size_t stride,
                      std::shared_ptr<void> owner);

} // namespace dewpoint::capture
