// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/project.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <filesystem>
#include <vector>

namespace dewpoint::session {

/// Returns the background images of a project's cameras, which show the scene without targets, in
/// project order. An image is empty if none was given for the camera. Errors name the file and the
/// camera.
Result<std::vector<cv::Mat>> loadBackgroundImages(const Project& project);

/// Writes an image from a camera of the project (CV_8UC3, rotated as in the project) to a folder as
/// the background image of this camera. The rotation is undone in the file. The folder is created
/// if it does not exist, and the file gets a new name. Returns the file, or FileUnwritable if it
/// cannot be written. Waits for the disk, so do not call it from a window's thread.
Result<std::filesystem::path> saveBackgroundImage(const Project& project, std::size_t camera,
                                                  const cv::Mat& image,
                                                  const std::filesystem::path& folder);

} // namespace dewpoint::session
