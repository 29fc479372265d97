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

/// Connection to one device or stream through a GStreamer pipeline (pipelineText()).
///
/// No call waits longer than about 2 s. open() fails if nothing arrives in this time. grab()
/// returns false if nothing has arrived for this time, or if the stream has ended or reports an
/// error. Before the first key frame of a stream, data arrive that cannot be decoded yet: grab()
/// then returns true, and retrieve() returns an empty image.
///
/// Capture times are computed by BufferClock from the time stamps of the images.
class GstStream final : public LiveStream {
public:
  /// `feed` receives all images before they are decoded; may be null.
  GstStream(PipelineText pipeline, EncodedFeedPtr feed);
  GstStream(const GstStream&) = delete;
  GstStream& operator=(const GstStream&) = delete;
  ~GstStream() override;

  /// Creates the pipeline without starting it. If this was not called, open() creates the pipeline.
  tl::expected<void, std::string> createPipeline();
  tl::expected<void, std::string> open() override;
  bool grab() override;
  cv::Mat retrieve() override;
  std::optional<CaptureInstant> captureTime() const override { return captured_; }
  std::optional<std::chrono::steady_clock::time_point> arrivalTime() const override {
    return arrived_;
  }
  std::string lostReason() const override { return lost_; }
  bool hasEnded() const override { return ended_ && pipelineText_.isFinite; }

  /// Returns the pipeline; null before createPipeline() or open().
  _GstElement* pipeline() const { return pipeline_.get(); }

private:
  using Clock = std::chrono::steady_clock;
  struct EncodedBranch;

  bool isSilent() const;
  /// Returns whether the last image has come out of every branch of the pipeline.
  bool haveSinksEnded() const;
  /// Returns whether the stream continues, without an end or an error.
  bool isAlive();
  /// Returns the next decoded image. Waits for at most `patience`; returns null after that.
  GstSamplePtr pull(Clock::duration patience);
  void take(GstSamplePtr sample);

  PipelineText pipelineText_;
  EncodedFeedPtr feed_;
  std::shared_ptr<EncodedBranch> branch_; ///< shared with the callbacks of its sink
  GstElementPtr pipeline_;
  _GstElement* imageSink_ = nullptr;   ///< in the pipeline
  _GstElement* encodedSink_ = nullptr; ///< in the pipeline; null if the user's has no such branch
  GstSamplePtr sample_;                ///< the image grabbed last
  GstSamplePtr first_;                 ///< an image that came while opening
  BufferClock clock_;
  std::optional<CaptureInstant> captured_;
  std::optional<Clock::time_point> arrived_;
  std::string lost_;
  bool ended_ = false;
};

} // namespace dewpoint::capture
