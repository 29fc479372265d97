// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Returns whether a name precedes another one in natural order: numbers by value ("camera 2"
/// before "camera 10"), letters regardless of case and accents (of Latin-1, in UTF-8), other
/// characters before digits before letters. Names that compare equal are ordered by their bytes.
/// This is for lists shown to users; frames of an image folder have their own order, see
/// naturallyBefore().
bool displayOrderLess(const std::string& name, const std::string& other);

/// Sorts files by name (without the folder) with displayOrderLess(). The order in which the user
/// chose them has no meaning, but cameras of a calibration may be matched by the order of their
/// files.
std::vector<std::string> inNaturalOrder(std::vector<std::string> files);

/// Returns whether a file may be a camera's recording, a video or an image: by its suffix, or by
/// its first bytes if the suffix is not conclusive. Only opening it shows whether it can be read.
bool isFootage(const std::filesystem::path& file);

/// Returns whether a file or folder may be the source of a camera: footage, a folder with at least
/// one file named like an image, a device, or something that does not exist (an address; missing
/// files are reported on opening).
bool canBeImageSource(const std::string& location);

/// Returns the possible cameras in a folder: videos and image folders, in natural order, without
/// subfolders of these. Empty if the folder cannot be read.
std::vector<std::string> footageIn(const std::filesystem::path& folder);

/// Returns the video devices of this computer, "/dev/video0", by name, without testing them.
std::vector<std::string> connectedCameras();

} // namespace dewpoint::setup
