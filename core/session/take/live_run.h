// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/project/project.h"
#include "core/session/frames/live_set.h"
#include "core/session/run/result_settings.h"
#include "core/trajectory/trajectory.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::session {

/// Results of a live run that tracked targets while a take (a recording of all cameras) was made.
struct LiveRun {
  Project project;       ///< the project with the settings at the end of the run
  Trajectory trajectory; ///< trajectory since the run's last start or restart
  std::string report;    ///< text of run.json, the report about the run
  std::vector<LiveFrameRecord> frameRecords; ///< the images of each frame of the run
  /// Frames that were tracked with other settings than those at the end.
  std::vector<ResultRange> framesWithOtherSettings;
};

/// Location, in the videos of a take, of an image that a live run tracked.
struct StoredImage {
  /// Number of the image in its video, from 0; -1: the image is not in the take.
  std::int64_t numberInVideo = -1;
  TimeStamp captureTime{}; ///< capture time in the live run
};

/// Locations, in the videos of a take, of the images of one frame of a live run.
struct StoredFrameSet {
  std::int64_t index = 0;
  TimeStamp time{};
  /// One per camera; empty if the camera had no image.
  std::vector<std::optional<StoredImage>> images;
};

/// Finds the images of a live run in the videos of a take, and returns their locations, frame by
/// frame. `stamps` has, for each camera, the stamps (CaptureInstant::imageId) that identify the
/// images in its video. Frames at the end of the run that have no image in the take are left out.
std::vector<StoredFrameSet>
locateStoredFrameSets(const std::vector<LiveFrameRecord>& sets,
                      const std::vector<std::vector<std::int64_t>>& stamps);

/// Name of the folder in a take that contains the results of the live run.
inline constexpr const char* kLiveFolder = "live";
/// Project file in a take, beside the videos, with the settings at the end of the live run.
inline constexpr const char* kLiveProject = "live.toml";

/// Returns a CSV table of the images of a live run, one line per frame: frame, time_ns, and for
/// each camera K image_K and time_K_ns. image_K is the number of the image in the video, `lost` if
/// the image is not in the take, or empty if the camera had none.
std::string storedFrameSetsCsv(const std::vector<StoredFrameSet>& sets);
/// Writes the CSV table of the images of a live run (storedFrameSetsCsv()) to a file. Returns an
/// /// error if the file cannot be written.
Status writeStoredFrameSets(const std::vector<StoredFrameSet>& sets,
                            const std::filesystem::path& file);
/// Reads the CSV table of the images of a live run (storedFrameSetsCsv()) from a file, for this ///
/// number of cameras. Returns the errors of readTextFile(), and NotParsed with the line number of a
/// /// row that is invalid or has numbers out of range.
Result<std::vector<StoredFrameSet>> readStoredFrameSets(const std::filesystem::path& file,
                                                        std::size_t cameras);

} // namespace dewpoint::session
