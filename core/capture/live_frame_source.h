// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame_source.h"
#include "core/capture/live_camera.h"
#include "core/capture/live_stream.h"

#include <memory>
#include <vector>

namespace dewpoint::capture {

/// Opens a live source with one thread per camera; each thread opens, reads and reconnects its
/// camera. Returns at once: only settings that can never work (an empty or unknown location, a
/// rotation that is not a multiple of 90 degrees) are errors. A camera that cannot be opened
/// (DeviceUnavailable), stopped delivering (ConnectionLost) or sends images of another size
/// (Mismatch) is a notice for as long as the problem lasts. The time of a frame is the reading of
/// the steady clock right after the grab, counted from this call, minus the delay of the camera.
Result<std::unique_ptr<FrameSetSource>> openLive(const std::vector<LiveCamera>& cameras);

/// As openLive(cameras), but connects through `factory` (for other kinds of devices, or for fakes
/// in tests).
Result<std::unique_ptr<FrameSetSource>> openLive(const std::vector<LiveCamera>& cameras,
                                                 const LiveStreamFactory& factory);

} // namespace dewpoint::capture
