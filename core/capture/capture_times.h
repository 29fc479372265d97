// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <string>
#include <vector>

namespace dewpoint::capture {

/// Capture times of the images of one camera, in seconds, in image order and ascending. The clock
/// is the same for all cameras in the recording.
using CaptureTimes = std::vector<double>;

/// First line of a table of capture times that is written during a recording.
inline constexpr const char* kRecordedTimesHeading =
    "# Capture times of a recording; a last line with the number of images ends it";
/// Beginning of the last line of a table of capture times that is written during a recording. The
/// number of images follows. If this line is missing, the recording was cut off.
inline constexpr const char* kRecordedTimesEnd = "# complete, images:";

/// Completeness of a table of capture times.
enum class TableCompleteness {
  Unknown,  ///< the table was not written during a recording of this program
  Complete, ///< the table has one time for each image of its video
  /// The recording was cut off, for example because the disk was full or the program was killed.
  /// The table and the video may then differ by a few images.
  CutOff,
};

/// Returns the completeness of a table of capture times, according to its first and last line.
/// Returns Unknown if the table cannot be read.
TableCompleteness completenessOf(const std::string& file);

/// Returns the names by which a table of capture times may identify a camera: the camera's name,
/// the number at the end of the file name of its images (`file`), and the number at the end of the
/// camera's name.
std::vector<std::string> captureTimeIds(const std::string& camera, const std::string& file);

/// Reads the capture times of one camera from a table.
///
/// The table has one line per image. Cells are separated by commas, semicolons, tabs or spaces, and
/// lines beginning with # are ignored. Without a header, the only (or last) column contains
/// seconds. With a header, the column is named time_s, timestamp_s, frame_time, timestamp, time or
/// t (seconds), or one of these names with the suffix _ms, _us or _ns. If there is a column named
/// cam_id, camera, camera_id, cam, port or device, only the lines of one camera are read. It is the
/// camera whose identifier is the first of `ids` that occurs in this column. Lines may be in any
/// order.
///
/// `field` names the camera in errors. Errors: FileMissing, FileUnreadable, NotParsed (with the
/// line), and BadValue if there are no times, no lines for the camera, or two images with the same
/// time.
Result<CaptureTimes> readCaptureTimes(const std::string& file, const std::vector<std::string>& ids,
                                      const std::string& field);

} // namespace dewpoint::capture
