// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Returns whether a name precedes another one in natural order. Numbers are ordered by value
/// ("camera 2" before "camera 10"). Letters are ordered regardless of case and of accents (those of
/// Latin-1, in UTF-8). Digits precede letters, and all other characters precede digits. Names that
/// compare equal are ordered by their bytes. This order is for lists shown to users; for the frames
/// of an image folder, see isBeforeInNaturalOrder().
bool isBeforeInDisplayOrder(const std::string& name, const std::string& other);

/// Returns files in natural order of their names without the folder ("camera 2" before "camera
/// 10"). Use this function for files that a user has chosen: their order is arbitrary, but the
/// cameras of a calibration may be matched to them by order.
std::vector<std::string> sortedInNaturalOrder(std::vector<std::string> files);

/// Returns whether a file may be a camera's recording, that is, a video or an image. This is
/// decided by its suffix, or by its first bytes if the suffix is not conclusive. Only opening the
/// file shows whether it can be read.
bool isFootage(const std::filesystem::path& file);

/// Returns whether a location may be the source of a camera: footage, a folder with at least one
/// file named like an image, a device, or anything that is not in the file system. A text that is
/// not in the file system may be the address of a stream. If it is a missing file, opening the
/// source reports an error.
bool canBeImageSource(const std::string& location);

/// Returns the possible camera sources in a folder, in natural order: videos and image folders, but
/// not the subfolders of image folders. Empty if the folder cannot be read.
std::vector<std::string> footageIn(const std::filesystem::path& folder);

/// Returns the paths of the cameras that are connected to this computer ("/dev/video0"), ordered by
/// number. Includes cameras that the user has no permission to open. Queries the drivers, but does
/// not start any camera.
std::vector<std::string> connectedCameras();

} // namespace dewpoint::setup
