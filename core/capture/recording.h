// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame_source.h"
#include "core/capture/recorded_camera.h"

#include <memory>
#include <vector>

namespace dewpoint::capture {

/// Rates further apart than this share cannot be one rate, rounded in different ways. A judgment.
inline constexpr double kSameRate = 0.01;

/// Opens synchronized recordings: frame k of each camera shows the same instant, k / rate seconds
/// after the first, or what was taken nearest to it when there are tables of times
/// (CaptureSchedule). Of a camera that is late the picture nearest in time is taken, with its own
/// capture time; before its first and after its last one there is none, nor where a numbered
/// picture of a folder is missing, which is a notice. `framesPerSecond` 0 takes the rate by the
/// times, or the first video's own rate, else 30. Seeking is exact to the frame. Cameras of
/// different length give the shortest's frame count and one notice.
Result<std::unique_ptr<FrameSetSource>> openRecording(const std::vector<RecordedCamera>& cameras,
                                                      double framesPerSecond);

} // namespace dewpoint::capture
