// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <string>
#include <vector>

namespace dewpoint::capture {

/// Capture time of each image of a camera, in the order of the images, ascending: seconds by a
/// clock that all cameras of the recording share.
using CaptureTimes = std::vector<double>;

/// Names by which a table of times may identify a camera: its name, and the number at the end of
/// its name or of the name of its file.
std::vector<std::string> timesNames(const std::string& camera, const std::string& file);

/// Reads the capture times of one camera from a table.
///
/// The table has one line per image; cells are separated by comma, semicolon, tab or spaces, and
/// lines that begin with # are ignored. Without a header, the only (or last) column holds seconds.
/// With a header, the column is called time_s, timestamp_s, frame_time, timestamp, time or t
/// (seconds), or one of these names with the suffix _ms, _us or _ns. If there is a column cam_id,
/// camera, camera_id, cam, port or device, only the lines of one camera are read: the first of
/// `ids` that occurs in it. Lines need not be sorted.
///
/// `field` names the camera in errors. Errors: FileMissing, FileUnreadable, NotParsed (with the
/// line), and BadValue when there is no time, no line for the camera, or two images have the same
/// time.
Result<CaptureTimes> readCaptureTimes(const std::string& file, const std::vector<std::string>& ids,
                                      const std::string& field);

} // namespace dewpoint::capture
