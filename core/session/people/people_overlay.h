// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame.h"
#include "core/geometry/camera.h"
#include "core/tracking/tracker_capabilities.h"

#include <opencv2/core.hpp>

#include <filesystem>
#include <vector>

namespace dewpoint::session {

/// Returns the color in which a person with this identity is drawn (blue, green, red). Twelve
/// colors that are easy to distinguish are used cyclically.
cv::Scalar identityColor(int identity);

/// Returns one image (CV_8UC3) with the images of all cameras next to each other. The outline of
/// every person's 95 % volume and the person's identity are drawn in each. Each camera's image is
/// `width` pixels wide, and black if it is missing.
cv::Mat peopleOverlay(const PeopleFinding& people, const FrameSet& frames, const CameraRig& rig,
                      int width);

/// Writes images of the same width to one file, one below another. Returns FileUnwritable if this
/// fails.
Status writeContactSheet(const std::vector<cv::Mat>& rows, const std::filesystem::path& file);

} // namespace dewpoint::session
