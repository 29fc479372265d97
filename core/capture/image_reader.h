// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/picture_reader.h"

#include <string>

namespace dewpoint::capture {

/// Returns whether a file is an image, by its file name extension.
bool isPictureFile(const std::string& path);

/// Reader for the images of a folder, in the order of naturallyBefore(). `field` names the camera
/// in errors: FileMissing, FileUnreadable.
Result<PictureReaderPtr> openImageReader(const std::string& folder, const std::string& field);

/// Reader for a single image file. Whether the file can be read is found out by the first read.
Result<PictureReaderPtr> openPictureReader(const std::string& file, const std::string& field);

} // namespace dewpoint::capture
