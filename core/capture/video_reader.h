// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_times.h"
#include "core/capture/frame_reader.h"

#include <optional>
#include <string>
#include <vector>

namespace dewpoint::capture {

/// Capture times of a video that this program has recorded. They differ from the time stamps in the
/// video only by a constant.
struct RecordedStamps {
  CaptureTimes times;
  /// False if the recording was cut off. The number of images is then counted in the video.
  bool isComplete = false;
};

/// Returns the capture times in a table that this program wrote while recording the video. Returns
/// nothing for other tables. `ids`: names by which the table may identify the camera
/// (captureTimeIds()).
std::optional<RecordedStamps> readRecordedStamps(const std::string& table,
                                                 const std::vector<std::string>& ids);

/// Opens a reader for the images in a video file. `field` names the camera in errors. With the
/// capture times that were written while recording the video (`recorded`), the reader finds images
/// quickly and exactly even if they are not evenly spaced in time. Errors: FileMissing,
/// FileUnreadable.
Result<FrameReaderPtr> openVideoReader(const std::string& path, const std::string& field,
                                       std::optional<RecordedStamps> recorded = std::nullopt);

} // namespace dewpoint::capture
