// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/devices/device_access.h"
#include "core/capture/frame_source.h"
#include "core/capture/gstreamer/encoded_feed.h"
#include "core/capture/live_camera.h"
#include "core/capture/live_stream.h"

#include <memory>
#include <vector>

namespace dewpoint::capture {

/// Checks whether the program supports this type of location. Nothing is opened.
Status checkLocation(const LiveCamera& camera);

/// Creates the connection for the camera's location, not yet opened. GStreamer opens devices,
/// addresses, pipelines and test patterns (pipelineText()). FFmpeg opens what GStreamer cannot open
/// on this computer: rtmp:// and tcp://, and addresses for which an element is missing, such as
/// http:// where the plugin with souphttpsrc is not installed. Its time-outs are longer (3 s), its
/// images have the time of their arrival, and a recording gets them decoded.
///
/// If the camera has the settings of a device, the device is found by its identity
/// (makeDeviceStream()).
///
/// `feed` gets all images as they come; null if nobody wants them.
LiveStreamPtr makeLiveStream(const LiveCamera& camera, EncodedFeedPtr feed);

/// Opens a live source (see live_frame_source.h) with these connections.
Result<std::unique_ptr<FrameSetSource>> openLive(const std::vector<LiveCamera>& cameras);

/// Same, with a feed for each camera, in their order. The feeds outlive the source. `devices` are
/// those among which cameras with an identity find theirs.
Result<std::unique_ptr<FrameSetSource>> openLive(const std::vector<LiveCamera>& cameras,
                                                 const std::vector<EncodedFeedPtr>& feeds,
                                                 DeviceAccessPtr devices = systemDevices());

} // namespace dewpoint::capture
