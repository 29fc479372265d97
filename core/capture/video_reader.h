// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/picture_reader.h"

#include <string>

namespace dewpoint::capture {

/// Reader for the images of a video file. `field` names the camera in errors: FileMissing,
/// FileUnreadable.
Result<PictureReaderPtr> openVideoReader(const std::string& path, const std::string& field);

} // namespace dewpoint::capture
