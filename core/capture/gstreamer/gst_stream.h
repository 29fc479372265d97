// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/gstreamer/buffer_clock.h"
#include "core/capture/gstreamer/encoded_feed.h"
#include "core/capture/gstreamer/gst_library.h"
#include "core/capture/gstreamer/pipeline_text.h"
#include "core/capture/live_stream.h"

#include <atomic>
#include <memory>
#include <optional>
#include <string>

namespace dewpoint::capture {

/// Connection to one device or stream by a GStreamer pipeline (pipelineText()).
///
/// No call waits longer than about 2 s: open() fails if nothing arrives in this time, and grab()
/// returns false if the stream has been silent for so long, has ended, or reports an error. While
/// data arrive of which no image can be made yet, as before the first key frame of a stream, grab()
/// returns true and retrieve() an empty image.
///
/// Capture times are the time stamps of the buffers by the monotonic clock (BufferClock).
class GstStream final : public LiveStream {
public:
  /// `feed` gets all images as they come; null if nobody wants them.
  GstStream(PipelineText pipeline, EncodedFeedPtr feed);
  GstStream(const GstStream&) = delete;
  GstStream& operator=(const GstStream&) = delete;
  ~GstStream() override;

  /// Makes the pipeline without starting it. open() does so itself if needed.
  tl::expected<void, std::string> prepare();
  tl::expected<void, std::string> open() override;
  bool grab() override;
  cv::Mat retrieve() override;
  std::optional<CaptureInstant> captureTime() const override { return captured_; }
  std::optional<std::chrono::steady_clock::time_point> arrivalTime() const override {
    return arrived_;
  }
  std::string lostReason() const override { return lost_; }
  bool hasEnded() const override { return ended_ && pipelineText_.isFinite; }

  /// Returns the pipeline, which exists after prepare().
  _GstElement* pipeline() const { return pipeline_.get(); }

private:
  using Clock = std::chrono::steady_clock;
  struct EncodedBranch;

  bool isSilent() const;
  /// Whether the stream goes on: no error, no end.
  bool isAlive();
  /// The next decoded image, waiting for at most `patience`.
  GstSamplePtr pull(Clock::duration patience);
  void take(GstSamplePtr sample);

  PipelineText pipelineText_;
  EncodedFeedPtr feed_;
  std::shared_ptr<EncodedBranch> branch_; ///< shared with the callbacks of its sink
  GstElementPtr pipeline_;
  _GstElement* imageSink_ = nullptr; ///< in the pipeline
  GstSamplePtr sample_;              ///< the image grabbed last
  GstSamplePtr first_;               ///< an image that came while opening
  BufferClock clock_;
  std::optional<CaptureInstant> captured_;
  std::optional<Clock::time_point> arrived_;
  std::string lost_;
  bool ended_ = false;
};

} // namespace dewpoint::capture
