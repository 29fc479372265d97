// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/picture_reader.h"

#include <string>

namespace dewpoint::capture {

/// Whether a file is a picture, by the ending of its name.
bool isPictureFile(const std::string& path);

/// The pictures of a folder, in the order of naturallyBefore(). `field` names the camera in errors:
/// FileMissing, FileUnreadable.
Result<PictureReaderPtr> openImageReader(const std::string& folder, const std::string& field);

/// One picture; whether it can be read shows only then.
Result<PictureReaderPtr> openPictureReader(const std::string& file, const std::string& field);

} // namespace dewpoint::capture
