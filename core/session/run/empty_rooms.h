// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/project.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <filesystem>
#include <vector>

namespace dewpoint::session {

/// Loads the background image of each camera of a project, in its order; empty for cameras without
/// one. The error names the file and the camera.
Result<std::vector<cv::Mat>> loadEmptyRooms(const Project& project);

/// Saves an image of a project's camera (CV_8UC3, rotated) as its background image. The image is
/// rotated back and written under a new name to `folder`, which is created if necessary. Returns
/// the file, or FileUnwritable. Blocks on disk access: do not call from the thread of a window.
Result<std::filesystem::path> keepEmptyRoom(const Project& project, std::size_t camera,
                                            const cv::Mat& image,
                                            const std::filesystem::path& folder);

} // namespace dewpoint::session
