// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/project.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <filesystem>
#include <vector>

namespace dewpoint::session {

/// Returns the background images of a project's cameras, which show the scene without targets: one
/// per camera, in project order, empty if the project names none for this camera. Errors name the
/// file and the camera.
Result<std::vector<cv::Mat>> loadBackgroundImages(const Project& project);

/// Writes the background image of a camera to a folder and returns the new file. `image` is
/// CV_8UC3, rotated as the project states; the rotation is undone in the file. The folder is
/// created if it does not exist, and the file gets a name that is not in use. Returns
/// FileUnwritable if the file cannot be written. Waits for the disk, so do not call this from a
/// window's thread.
Result<std::filesystem::path> saveBackgroundImage(const Project& project, std::size_t camera,
                                                  const cv::Mat& image,
                                                  const std::filesystem::path& folder);

} // namespace dewpoint::session
