// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_times.h"
#include "core/capture/frame_reader.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// Capture times of a video that this program has recorded. The time stamps in the video are the
/// same, except for a constant.
struct RecordedStamps {
  CaptureTimes times;
  /// False if the recording was cut off; the images are counted in the video then.
  bool isComplete = false;
};

/// Returns the times in a table that was written together with its video, or nothing for other
/// tables. `ids`: as for readCaptureTimes().
std::optional<RecordedStamps> recordedStamps(const std::string& table,
                                             const std::vector<std::string>& ids);

/// Opens a reader for the images in a video file. `field` names the camera in errors. `recorded`
/// makes it fast and exact where the images are not evenly spaced. Errors: FileMissing,
/// FileUnreadable.
Result<FrameReaderPtr> openVideoReader(const std::string& path, const std::string& field,
                                       std::optional<RecordedStamps> recorded = std::nullopt);

} // namespace dewpoint::capture
