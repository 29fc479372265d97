// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/project.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <filesystem>
#include <vector>

namespace dewpoint::session {

/// What the cameras of a project show when no target is there, in its order; an empty picture where
/// that was not said. The error names the file and the camera.
Result<std::vector<cv::Mat>> loadBackgroundImages(const Project& project);

/// Writes an image that a camera of the project shows (CV_8UC3, rotated) as a picture of its empty
/// room, rotated back, into a folder, which is made when it does not exist; the file's name is a
/// new one. Returns the file, FileUnwritable when it cannot be written. Waits for the disk: not for
/// the thread of a window.
Result<std::filesystem::path> keepBackgroundImage(const Project& project, std::size_t camera,
                                                  const cv::Mat& image,
                                                  const std::filesystem::path& folder);

} // namespace dewpoint::session
