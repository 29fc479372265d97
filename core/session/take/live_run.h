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

/// Results of a live run while a take was recorded.
struct LiveRun {
  Project project;           ///< as the run was at its end
  Trajectory trajectory;     ///< since its start or restart
  std::string report;        ///< text of run.json
  std::vector<LiveSet> sets; ///< the images of its frames
  /// Frames that were tracked with other settings than those at the end.
  std::vector<ResultRange> otherSettings;
};

/// An image that a live run tracked, in the videos of a take.
struct StoredImage {
  std::int64_t number = -1; ///< of the image in its video, from 0; -1: the take does not have it
  TimeStamp captureTime{};  ///< in the live run
};

/// The images of one frame of a live run, in the videos of a take.
struct StoredSet {
  std::int64_t index = 0;
  TimeStamp time{};
  std::vector<std::optional<StoredImage>> images; ///< per camera; nothing: it had no image
};

/// Finds the images of a live run in the videos of a take. `stamps` has for each camera the stamps
/// of the images in its video. Frames after the last one of which the take has an image are left
/// out.
std::vector<StoredSet> storedSets(const std::vector<LiveSet>& sets,
                                  const std::vector<std::vector<std::int64_t>>& stamps);

/// Folder in a take for the results of the live run.
inline constexpr const char* kLiveFolder = "live";
/// Project in a take with the settings at the end of the live run. It is beside the videos, so that
/// it names them by relative paths.
inline constexpr const char* kLiveProject = "live.toml";

/// Returns the table of the images of a live run, one line per frame: frame, time_ns, and for each
/// camera image_K and time_K_ns. The image is the number in the video, `lost`, or empty.
std::string storedSetsText(const std::vector<StoredSet>& sets);
/// Writes this table to a file.
Status writeStoredSets(const std::vector<StoredSet>& sets, const std::filesystem::path& file);
/// Reads this table. Errors: those of readTextFile(), and NotParsed with the line of
/// a row that is not one of this table, or whose numbers are not those of a run.
Result<std::vector<StoredSet>> readStoredSets(const std::filesystem::path& file,
                                              std::size_t cameras);

} // namespace dewpoint::session
