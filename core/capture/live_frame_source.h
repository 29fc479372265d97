// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame_source.h"
#include "core/capture/live_camera.h"
#include "core/capture/live_stream.h"

#include <memory>
#include <vector>

namespace dewpoint::capture {

/// Starts one thread per camera, each opening, reading and reconnecting on its own, and returns at
/// once: only settings that can never work (an empty or unknown location, a rotation that is no
/// multiple of 90) fail. A camera that cannot be opened (DeviceUnavailable), stopped delivering
/// (ConnectionLost) or sends another picture size (Mismatch) is a notice for as long as that lasts.
/// Frames carry the steady clock's reading right after the grab, counted from this call, less
/// their camera's delay.
Result<std::unique_ptr<FrameSetSource>> openLive(const std::vector<LiveCamera>& cameras);

/// As openLive(cameras), but with other connections (devices of another kind, or fakes in tests).
Result<std::unique_ptr<FrameSetSource>> openLive(const std::vector<LiveCamera>& cameras,
                                                 const LiveStreamFactory& factory);

} // namespace dewpoint::capture
