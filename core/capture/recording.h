// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame_source.h"
#include "core/capture/recorded_camera.h"

#include <memory>
#include <vector>

namespace dewpoint::capture {

/// Largest relative difference between two frame rates that are the same rate rounded differently.
/// A judgment.
inline constexpr double kRateTolerance = 0.01;

/// Opens synchronized recordings.
///
/// Frame k of every camera is at the same time, k / rate seconds after the first frame. With tables
/// of capture times, it is the image closest to that time (CaptureSchedule). For a camera with a
/// delay, the image closest in time is used, with its own capture time. The camera has no image
/// before its first or after its last one. It also has no image where a numbered image is missing
/// from a folder, which is reported as a notice. If `framesPerSecond` is 0, the rate is determined
/// from the capture times, or else from the first video, or else is 30. Seeking is frame-accurate.
/// If cameras differ in length, the frame count is that of the shortest, and one notice reports it.
Result<std::unique_ptr<FrameSetSource>> openRecording(const std::vector<RecordedCamera>& cameras,
                                                      double framesPerSecond);

} // namespace dewpoint::capture
