// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <string>
#include <vector>

namespace dewpoint::capture {

/// Capture times of the images of one camera, in seconds, in image order and ascending. The clock
/// is the same for all cameras in the recording.
using CaptureTimes = std::vector<double>;

/// First line of a table that grew with its recording; ...
inline constexpr const char* kRecordedTimesHeading =
    "# Capture times of a recording; a last line with the number of images ends it";
/// ... and the beginning of its last line, without which the recording was cut off.
inline constexpr const char* kRecordedTimesEnd = "# complete, images:";

/// What a table says about whether it has the time of every image.
enum class TableCompleteness {
  Unknown,  ///< it was not written by a recording of this program
  Complete, ///< it has exactly the images of its video, which has their times, too
  /// The recording was cut off, by a full disk or because the program was killed: either the table
  /// or the video has some more images.
  CutOff,
};

/// Returns what a table of capture times says about its completeness; Unknown if it cannot be read.
TableCompleteness completenessOf(const std::string& file);

/// Returns the names by which a table of capture times may identify a camera: its name, the number
/// at the end of its file name, and the number at the end of its name.
std::vector<std::string> captureTimeIds(const std::string& camera, const std::string& file);

/// Reads the capture times of one camera from a table.
///
/// The table has one line per image. Cells are separated by commas, semicolons, tabs or spaces, and
/// lines beginning with # are ignored. Without a header, the only (or last) column contains
/// seconds. With a header, the column is named time_s, timestamp_s, frame_time, timestamp, time or
/// t (seconds), or one of these names with the suffix _ms, _us or _ns. If there is a column named
/// cam_id, camera, camera_id, cam, port or device, only the lines of one camera are read: the first
/// of `ids` that occurs in it. Lines may be in any order.
///
/// `field` names the camera in errors. Errors: FileMissing, FileUnreadable, NotParsed (with the
/// line), and BadValue if there are no times, no lines for the camera, or two images with the same
/// time.
Result<CaptureTimes> readCaptureTimes(const std::string& file, const std::vector<std::string>& ids,
                                      const std::string& field);

} // namespace dewpoint::capture
