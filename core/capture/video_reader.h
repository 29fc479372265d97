// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_reader.h"

#include <string>

namespace dewpoint::capture {

/// Opens a reader for the images in a video file. `field` names the camera in errors. Errors:
/// FileMissing, FileUnreadable.
Result<FrameReaderPtr> openVideoReader(const std::string& path, const std::string& field);

} // namespace dewpoint::capture
