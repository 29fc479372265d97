// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_reader.h"

#include <string>

namespace dewpoint::capture {

/// Returns whether a file is an image, based on its file name extension.
bool isImageFile(const std::string& path);

/// Opens a reader for the images in a folder, in natural order of their names, so that "2" comes
/// before "10". `field` names the camera in errors. Errors: FileMissing, FileUnreadable.
Result<FrameReaderPtr> openImageFolderReader(const std::string& folder, const std::string& field);

/// Opens a reader for a single image file. An unreadable file is not detected until the first read.
Result<FrameReaderPtr> openImageFileReader(const std::string& file, const std::string& field);

} // namespace dewpoint::capture
