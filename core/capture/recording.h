// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame_source.h"
#include "core/capture/recorded_camera.h"

#include <memory>
#include <vector>

namespace dewpoint::capture {

/// Relative difference above which two frame rates cannot be the same rate, rounded differently. A
/// judgment.
inline constexpr double kSameRate = 0.01;

/// Opens synchronized recordings.
///
/// Frame k of each camera shows the same time, k / rate seconds after the first frame, or, with
/// tables of capture times, the image nearest to that time (CaptureSchedule). For a camera with a
/// delay, the image nearest in time is used, with its own capture time; before its first and after
/// its last image the camera has none. A camera also has no image where a numbered image of a
/// folder is missing, which is a notice. If `framesPerSecond` is 0, the rate is that of the capture
/// times, else that of the first video, else 30. Seeking is exact to the frame. If cameras differ
/// in length, the frame count is that of the shortest, and there is one notice.
Result<std::unique_ptr<FrameSetSource>> openRecording(const std::vector<RecordedCamera>& cameras,
                                                      double framesPerSecond);

} // namespace dewpoint::capture
