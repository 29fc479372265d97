// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/capture/capture_instant.h"
#include "core/capture/live_camera.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace dewpoint::capture {

/// Name of the sink that receives decoded images, in pipelines made by pipelineText().
inline constexpr const char* kImageSinkName = "dewpoint_images";
/// Name of the sink that receives every image before it is decoded.
inline constexpr const char* kEncodedSinkName = "dewpoint_encoded";

/// GStreamer pipeline of one camera, as text for gst_parse_launch():
///
///     source ! parsebin ! tee ! queue that drops old images ! decoder ! videoconvert ! BGR appsink
///                         tee ! queue ! appsink for recording
///
/// Only recording uses the second branch, so recording loses no images if the view is slow.
struct PipelineText {
  std::string text;
  TimeOrigin origin = TimeOrigin::Arrival; ///< source of the images' time stamps
  /// True if the user specified a pipeline that ends in an appsink. Decoded images then come from
  /// this appsink, and there is no branch for recording.
  bool hasOwnSink = false;
  std::string devicePath{};            ///< path of the V4L2 device; empty if there is none
  bool isFinite = false;               ///< true if the stream ends after a certain number of images
  std::vector<std::string> elements{}; ///< names of the GStreamer elements that the pipeline needs
};

/// Returns the pipeline for the location of a camera:
///
/// - a number, /dev/videoN, or another path below /dev such as /dev/v4l/by-id/...: V4L2. The format
///   is requested as described for requestedFormat() (device_caps.h).
/// - rtsp://, rtsps://: RTSP. http://, https://: multipart MJPEG and other formats that GStreamer
///   recognizes. srt://: SRT.
/// - udp://host:port: MPEG-TS over UDP. rtp://host:port: RTP over UDP, MPEG-TS unless the option
///   `encoding` (JPEG, H264, H265 or MP2T) names another payload; `payload` is its number.
/// - gst:PIPELINE: a pipeline that ends in an appsink, or in raw or encoded video without a sink.
/// - test:PATTERN?width=640&height=480&rate=30&encoding=raw&frames=0: a pattern of videotestsrc,
///   such as test:ball. `encoding` is raw, mjpeg or h264; `frames` is the number of images after
///   which the stream ends (0: never).
///
/// Opens nothing. If the location contains a password, the returned text contains it, too. Error:
/// BadValue, with the location without its password.
Result<PipelineText> pipelineText(const LiveCamera& camera);

/// Returns whether only FFmpeg can open a location (rtmp://, tcp://).
bool isOnlyForFfmpeg(std::string_view location);

/// Returns the pipeline that writes images of a stream into a Matroska file named `file`.
/// `mediaType`: media type of the images, for example image/jpeg or video/x-raw. Encoded images are
/// stored unchanged. Raw images are stored as JPEG of quality 95, or unchanged if `lossless`. The
/// images enter through the appsrc named "source"; the muxer is named "muxer".
std::string recordingPipelineText(const std::string& mediaType, bool lossless,
                                  const std::string& file);

/// Returns whether a lossless recording stores raw images in this GStreamer format without changing
/// any pixel.
bool isStoredLossless(std::string_view rawFormat);

/// Returns the pipeline that decodes the video of a recording with the same decoders as the images
/// of a live camera. It ends in an appsink named kImageSinkName.
std::string storedPipelineText(const std::string& file);

} // namespace dewpoint::capture
