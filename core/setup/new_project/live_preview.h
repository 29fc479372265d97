// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/live_camera.h"
#include "core/capture/live_stream.h"

#include <opencv2/core/mat.hpp>

#include <functional>
#include <string>

namespace dewpoint::setup {

/// One image of a live source, and the properties of the source that are known at that time.
struct LivePreview {
  cv::Mat image;                ///< CV_8UC3 (BGR), scaled down to at most 192 columns
  cv::Size size;                ///< size of the images as the source sends them, pixels
  double framesPerSecond = 0.0; ///< measured frame rate; 0 while it is not known
};

/// Function that is called with each preview, in the thread of previewLive(). It returns whether to
/// continue.
using PreviewReceiver = std::function<bool(const LivePreview&)>;

/// Opens a live source, and passes an image to `receive` every `interval` seconds until `receive`
/// returns false. Other images are skipped. If an image cannot be decoded, `receive` gets an empty
/// preview, so that it can end the function at any time. Blocks; call it in a separate thread.
///
/// `camera` specifies the location and may request a size; its rotation is not used. Errors:
/// DeviceUnavailable or BadValue if the source cannot be opened, ConnectionLost if it stops
/// sending. Passwords are removed from the locations in errors.
Status previewLive(const LiveCamera& camera, double interval, const PreviewReceiver& receive);
/// Opens a live source with a connection created by `factory`, and passes an image to `receive`
/// every `interval` seconds. In all other respects, it is like the overload without `factory`.
Status previewLive(const LiveCamera& camera, double interval, const PreviewReceiver& receive,
                   const LiveStreamFactory& factory);

/// Opens a live source for about a second. Returns its first image, the size of the images and the
/// frame rate. `goesOn` is called from time to time; if it returns false, the function ends early.
/// Errors: those of previewLive(); Canceled if `goesOn` returned false; DeviceUnavailable if no
/// image arrives within 5 s.
Result<LivePreview> captureLivePreview(const std::string& location,
                                       const std::function<bool()>& goesOn);

} // namespace dewpoint::setup
