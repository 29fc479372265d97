// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/live_camera.h"
#include "core/capture/live_stream.h"

#include <opencv2/core/mat.hpp>

#include <functional>
#include <string>

namespace dewpoint::setup {

/// One image of a live source, and what is known about the source by then.
struct LivePreview {
  cv::Mat image;                ///< CV_8UC3 (BGR), scaled down to at most 192 columns
  cv::Size size;                ///< size of the images as the source sends them, pixels
  double framesPerSecond = 0.0; ///< measured; 0 while it is not known
};

/// Called with each preview, in the thread of watchLive(). Returns whether to continue.
using PreviewReceiver = std::function<bool(const LivePreview&)>;

/// Opens a live source, and passes an image to `receive` every `interval` seconds until it returns
/// false. Images between them are neither converted nor kept. If the source sends nothing, it
/// passes empty previews, so that the receiver can end it. Blocks: for a thread of its own. Returns
/// the reason if the source cannot be opened (DeviceUnavailable, BadValue) or stops sending
/// (ConnectionLost); passwords in addresses are redacted. `camera` names the location, and may ask
/// for a size; its rotation is not used.
Status watchLive(const LiveCamera& camera, double interval, const PreviewReceiver& receive);
/// As above, with connections of the caller.
Status watchLive(const LiveCamera& camera, double interval, const PreviewReceiver& receive,
                 const LiveStreamFactory& factory);

/// Opens a live source for about a second, and returns its first image, with its size and its rate.
/// Ends early, with the error Canceled, once `goesOn` returns false. Errors: those of watchLive(),
/// and DeviceUnavailable if no image arrives within 5 s.
Result<LivePreview> tryLive(const std::string& location, const std::function<bool()>& goesOn);

} // namespace dewpoint::setup
