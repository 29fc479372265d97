// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/frame_source.h"
#include "core/capture/live_camera.h"
#include "core/capture/live_stream.h"

#include <memory>
#include <vector>

namespace dewpoint::capture {

/// Opens a live source with one thread per camera. Each thread opens, reads and reconnects its
/// camera. Returns immediately. Only settings that can never work are errors: an empty or unknown
/// location, or a rotation that is not a multiple of 90 degrees.
///
/// Other problems of a camera are reported as notices for as long as they last: the camera cannot
/// be opened (DeviceUnavailable), has stopped delivering (ConnectionLost), sends images of a
/// different size (Mismatch), or sends images that are black, frozen, repeated, late or too few
/// (ImageHealth).
///
/// The time of a frame is its capture time minus the camera's delay, counted from the call of this
/// function. If the connection does not report a capture time (LiveStream::captureTime()), the time
/// right after the image was grabbed is used instead. `factory` creates the connections; see
/// gstreamer/open_live.h for the connections that this program uses.
Result<std::unique_ptr<FrameSetSource>> openLive(const std::vector<LiveCamera>& cameras,
                                                 const LiveStreamFactory& factory);

} // namespace dewpoint::capture
