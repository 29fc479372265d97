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

/// The color of an identity everywhere, BGR: twelve that are easy to tell apart, then again.
cv::Scalar identityColor(int identity);

/// The images of all cameras side by side, each `width` pixels wide, with the outline of every
/// person's 95 % volume and its identity (CV_8UC3). Missing images are black.
cv::Mat peopleOverlay(const PeopleFinding& people, const FrameSet& frames, const CameraRig& rig,
                      int width);

/// Writes pictures of one width, one below the other, as one picture file; FileUnwritable.
Status writeContactSheet(const std::vector<cv::Mat>& rows, const std::filesystem::path& file);

} // namespace dewpoint::session
