// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame_source.h"
#include "core/capture/recorded_camera.h"

#include <memory>
#include <vector>

namespace dewpoint::capture {

/// Largest relative difference at which two frame rates count as equal, to allow for rounding.
/// Chosen by judgment.
inline constexpr double kRateTolerance = 0.01;

/// Opens synchronized recordings.
///
/// Frame k of every camera is at the same time, k / rate seconds after the first frame. If a camera
/// has a delay or a table of capture times, the frame contains the image whose capture time is
/// closest to the time of the frame (CaptureSchedule). A camera has no image at times before its
/// first or after its last image. It also has no image where a numbered image is missing from a
/// folder, which is reported as a notice. If `framesPerSecond` is 0, the rate is computed from the
/// capture times. If there are no capture times, it is the rate of the first video, or 30 if there
/// is no video. Seeking is frame-accurate. If the recordings differ in length, the frame count is
/// that of the shortest one, and a notice reports this.
Result<std::unique_ptr<FrameSetSource>> openRecording(const std::vector<RecordedCamera>& cameras,
                                                      double framesPerSecond);

} // namespace dewpoint::capture
