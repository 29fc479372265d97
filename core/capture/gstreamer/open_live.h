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

/// Checks that the program supports the type of the camera's location. Opens nothing. Error:
/// BadValue.
Status checkLocation(const LiveCamera& camera);

/// Creates an unopened connection to the camera's location. GStreamer opens devices, addresses,
/// pipelines and test patterns (pipelineText()).
///
/// FFmpeg opens the addresses that GStreamer cannot open on this computer: rtmp:// and tcp://, and
/// addresses for which a GStreamer element is missing. With FFmpeg, time-outs are longer (3 s), the
/// capture time of an image is its time of arrival, and a recording receives decoded images.
///
/// If the camera has device settings, the device is found by its identity (makeDeviceStream()).
///
/// `feed` receives all images for a recording; may be null.
LiveStreamPtr makeLiveStream(const LiveCamera& camera, EncodedFeedPtr feed);

/// Opens a source of live images with one thread per camera (see live_frame_source.h). The cameras
/// are connected through GStreamer or FFmpeg (makeLiveStream()).
Result<std::unique_ptr<FrameSetSource>> openLive(const std::vector<LiveCamera>& cameras);

/// Opens a source of live images whose cameras are connected through GStreamer or FFmpeg
/// (makeLiveStream()). `feeds` passes undecoded images to recordings. It has one entry per camera,
/// in the same order; the feeds outlive the source. Cameras with a device identity are searched for
/// among `devices`.
Result<std::unique_ptr<FrameSetSource>> openLive(const std::vector<LiveCamera>& cameras,
                                                 const std::vector<EncodedFeedPtr>& feeds,
                                                 DeviceAccessPtr devices = systemDevices());

} // namespace dewpoint::capture
