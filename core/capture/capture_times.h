// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <string>
#include <vector>

namespace dewpoint::capture {

/// When each picture of a camera was taken: seconds by a clock that all cameras of the recording
/// share, rising, in the order of the pictures.
using CaptureTimes = std::vector<double>;

/// What a table of times may call a camera: its name, or the number at the end of the name of its
/// file or of its own.
std::vector<std::string> timesNames(const std::string& camera, const std::string& file);

/// Reads the times of one camera from a table: a line per picture, cells separated by comma,
/// semicolon, tab or spaces, lines that begin with # left out. Without a heading the only column
/// (or the last one) holds seconds. With one the times stand in the column called time_s,
/// timestamp_s, frame_time, timestamp, time or t (seconds), or one of these that ends in _ms, _us
/// or _ns. When there is a column cam_id, camera, camera_id, cam, port or device, the lines of one
/// camera are taken: of the first of `ids` that is found there. Lines need not be sorted.
/// `field` names the camera in errors. Errors: FileMissing, FileUnreadable, NotParsed (line), and
/// BadValue when there is no time, no line of the camera, or two pictures have one time.
Result<CaptureTimes> readCaptureTimes(const std::string& file, const std::vector<std::string>& ids,
                                      const std::string& field);

} // namespace dewpoint::capture
