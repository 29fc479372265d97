// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/gst_stream.h"

#include "core/capture/gstreamer/gst_image.h"

#include <algorithm>
#include <deque>
#include <filesystem>
#include <gst/app/gstappsink.h>
#include <gst/gst.h>
#include <mutex>
#include <string_view>
#include <thread>
#include <utility>

namespace dewpoint::capture {

using namespace std::chrono_literals;

namespace {

constexpr auto kStreamSilence = 2s;       ///< after which a stream is lost
constexpr auto kLongestGrab = 1s;         ///< of a stream of which no image can be made yet
constexpr auto kPullSlice = 50ms;         ///< between two looks at errors
constexpr auto kEndSlice = 5ms;           ///< between two looks whether all branches have ended
constexpr std::size_t kArrivalsKept = 64; ///< more than a decoder holds back

using SteadyClock = std::chrono::steady_clock;

/// The time stamp of a sample by the steady clock.
std::optional<SteadyClock::time_point> stampOf(GstSample* sample, GstElement* element) {
  GstBuffer* buffer = gst_sample_get_buffer(sample);
  GstSegment* segment = gst_sample_get_segment(sample);
  const GstClockTime base = gst_element_get_base_time(element);
  if (buffer == nullptr || segment == nullptr || segment->format != GST_FORMAT_TIME ||
      !GST_CLOCK_TIME_IS_VALID(GST_BUFFER_PTS(buffer)) || !GST_CLOCK_TIME_IS_VALID(base)) {
    return std::nullopt;
  }
  const GstClockTime running =
      gst_segment_to_running_time(segment, GST_FORMAT_TIME, GST_BUFFER_PTS(buffer));
  if (!GST_CLOCK_TIME_IS_VALID(running)) {
    return std::nullopt;
  }
  return SteadyClock::time_point(std::chrono::nanoseconds(base + running));
}

/// The time stamp of a sample as it is, by which its compressed and its decoded form are known to
/// be the same image; -1 if it has none.
std::int64_t identityOf(GstSample* sample) {
  GstBuffer* buffer = gst_sample_get_buffer(sample);
  return buffer != nullptr && GST_CLOCK_TIME_IS_VALID(GST_BUFFER_PTS(buffer))
             ? static_cast<std::int64_t>(GST_BUFFER_PTS(buffer))
             : -1;
}

/// The appsink in a user's pipeline.
GstElement* ownSinkOf(GstElement* pipeline) {
  GstElement* found = nullptr;
  GstIterator* sinks = gst_bin_iterate_sinks(GST_BIN(pipeline));
  GValue item = G_VALUE_INIT;
  while (found == nullptr && gst_iterator_next(sinks, &item) == GST_ITERATOR_OK) {
    auto* element = static_cast<GstElement*>(g_value_get_object(&item));
    found = GST_IS_APP_SINK(element) ? element : nullptr;
    g_value_reset(&item);
  }
  g_value_unset(&item);
  gst_iterator_free(sinks);
  return found;
}

} // namespace

/// What the thread of the encoded branch and that of the camera share.
struct GstStream::EncodedBranch {
  EncodedBranch(EncodedFeedPtr destination, TimeOrigin origin)
      : feed(std::move(destination)), clock(origin) {}

  EncodedFeedPtr feed;
  BufferClock clock; ///< used only by the thread of the branch
  std::atomic<Clock::rep> lastData = 0;
  std::atomic<bool> hasData = false;
  std::mutex mutex; ///< guards `arrivals`
  /// Time stamps of the newest samples, and when they arrived.
  std::deque<std::pair<GstClockTime, Clock::time_point>> arrivals;

  void noteArrival(GstSample& sample, Clock::time_point arrival) {
    GstBuffer* buffer = gst_sample_get_buffer(&sample);
    if (buffer == nullptr || !GST_CLOCK_TIME_IS_VALID(GST_BUFFER_PTS(buffer))) {
      return;
    }
    std::scoped_lock lock(mutex);
    arrivals.emplace_back(GST_BUFFER_PTS(buffer), arrival);
    if (arrivals.size() > kArrivalsKept) {
      arrivals.pop_front();
    }
  }
  /// When the data of a decoded image arrived; decoders keep its time stamp.
  std::optional<Clock::time_point> arrivalOf(GstSample& sample) {
    GstBuffer* buffer = gst_sample_get_buffer(&sample);
    if (buffer == nullptr) {
      return std::nullopt;
    }
    std::scoped_lock lock(mutex);
    const auto found = std::ranges::find(arrivals, GST_BUFFER_PTS(buffer),
                                         &std::pair<GstClockTime, Clock::time_point>::first);
    return found != arrivals.end() ? std::optional(found->second) : std::nullopt;
  }

  void setData(Clock::time_point now) {
    lastData = now.time_since_epoch().count();
    hasData = true;
  }

  static GstFlowReturn receive(GstAppSink* sink, gpointer data) {
    const auto& branch = *static_cast<std::shared_ptr<EncodedBranch>*>(data);
    const auto arrival = Clock::now();
    const std::shared_ptr<GstSample> sample(gst_app_sink_pull_sample(sink), [](GstSample* owned) {
      if (owned != nullptr) {
        gst_sample_unref(owned);
      }
    });
    if (!sample) {
      return GST_FLOW_EOS;
    }
    branch->setData(arrival);
    branch->noteArrival(*sample, arrival);
    if (branch->feed) {
      const auto stamp = stampOf(sample.get(), GST_ELEMENT(sink));
      CaptureInstant captured = branch->clock.nextCaptureInstant(stamp, arrival);
      captured.imageId = identityOf(sample.get());
      branch->feed->put({sample, captured});
    }
    return GST_FLOW_OK;
  }
};

GstStream::GstStream(PipelineText pipeline, EncodedFeedPtr feed)
    : pipelineText_(std::move(pipeline)), feed_(std::move(feed)),
      branch_(std::make_shared<EncodedBranch>(feed_, pipelineText_.origin)),
      clock_(pipelineText_.origin) {}

GstStream::~GstStream() = default;

tl::expected<void, std::string> GstStream::createPipeline() {
  if (pipeline_) {
    return {};
  }
  std::error_code problem;
  if (!pipelineText_.devicePath.empty() &&
      !std::filesystem::exists(pipelineText_.devicePath, problem)) {
    return tl::make_unexpected(std::string("no such device is plugged in"));
  }
  std::string reason;
  pipeline_ = makePipeline(pipelineText_.text, reason);
  if (!pipeline_) {
    return tl::make_unexpected("the GStreamer pipeline cannot be made: " + reason);
  }
  GstElement* pipeline = pipeline_.get();
  const auto named = [&](const char* name) {
    GstElement* element = gst_bin_get_by_name(GST_BIN(pipeline), name);
    if (element != nullptr) {
      gst_object_unref(element); // the pipeline keeps it
    }
    return element;
  };
  imageSink_ = pipelineText_.hasOwnSink ? ownSinkOf(pipeline) : named(kImageSinkName);
  if (imageSink_ == nullptr) {
    return tl::make_unexpected(std::string("the GStreamer pipeline has no appsink at its end"));
  }
  encodedSink_ = named(kEncodedSinkName);
  if (encodedSink_ != nullptr) {
    GstAppSinkCallbacks callbacks{};
    callbacks.new_sample = &EncodedBranch::receive;
    gst_app_sink_set_callbacks(
        GST_APP_SINK(encodedSink_), &callbacks, new std::shared_ptr<EncodedBranch>(branch_),
        [](gpointer data) { delete static_cast<std::shared_ptr<EncodedBranch>*>(data); });
  }
  return {};
}

tl::expected<void, std::string> GstStream::open() {
  if (auto prepared = createPipeline(); !prepared) {
    return prepared;
  }
  branch_->lastData = Clock::now().time_since_epoch().count();
  const bool failed =
      gst_element_set_state(pipeline_.get(), GST_STATE_PLAYING) == GST_STATE_CHANGE_FAILURE;
  const auto deadline = Clock::now() + kStreamSilence;
  do {
    first_ = pull(kPullSlice); // before the look at its end: a short stream can be over by now
    if (first_ || branch_->hasData) {
      return {};
    }
  } while (isAlive() && !failed && Clock::now() < deadline);
  if (lost_.empty()) {
    lost_ = failed ? "it cannot be started" : "no answer for two seconds";
  }
  return tl::make_unexpected(lost_);
}

bool GstStream::isSilent() const {
  return Clock::now() - Clock::time_point(Clock::duration(branch_->lastData)) > kStreamSilence;
}

bool GstStream::haveSinksEnded() const {
  // The two branches have threads of their own: the one with all images can be behind.
  return gst_app_sink_is_eos(GST_APP_SINK(imageSink_)) != 0 &&
         (encodedSink_ == nullptr || gst_app_sink_is_eos(GST_APP_SINK(encodedSink_)) != 0);
}

bool GstStream::isAlive() {
  GstBus* bus = gst_element_get_bus(pipeline_.get());
  GstMessage* message = gst_bus_pop_filtered(bus, GST_MESSAGE_ERROR);
  gst_object_unref(bus);
  if (message != nullptr) {
    lost_ = gstMessageErrorText(message);
    gst_message_unref(message);
    return false;
  }
  // Not asked of the bus: it reports the end while images still wait in the sinks.
  ended_ = haveSinksEnded();
  if (ended_) {
    lost_ = "the stream has ended";
    if (feed_) {
      feed_->markEnded();
    }
  }
  return !ended_;
}

GstSamplePtr GstStream::pull(Clock::duration patience) {
  GstSamplePtr sample(gst_app_sink_try_pull_sample(
      GST_APP_SINK(imageSink_),
      static_cast<GstClockTime>(std::chrono::nanoseconds(patience).count())));
  if (sample && pipelineText_.hasOwnSink) {
    branch_->setData(Clock::now());
  }
  if (!sample && gst_app_sink_is_eos(GST_APP_SINK(imageSink_)) != 0) {
    std::this_thread::sleep_for(kEndSlice); // an ended sink answers at once
  }
  return sample;
}

void GstStream::take(GstSamplePtr sample) {
  sample_ = std::move(sample);
  const auto now = Clock::now();
  captured_ = clock_.nextCaptureInstant(stampOf(sample_.get(), imageSink_), now);
  captured_->imageId = identityOf(sample_.get());
  const auto arrived = branch_->arrivalOf(*sample_);
  arrived_ = arrived && *arrived < now ? *arrived : now;
  if (pipelineText_.hasOwnSink && feed_) {
    feed_->put(
        {std::shared_ptr<GstSample>(gst_sample_ref(sample_.get()), gst_sample_unref), *captured_});
  }
}

bool GstStream::grab() {
  sample_.reset();
  captured_.reset();
  arrived_.reset();
  const auto deadline = Clock::now() + kLongestGrab;
  while (Clock::now() < deadline) {
    if (GstSamplePtr sample = first_ ? std::move(first_) : pull(kPullSlice)) {
      if (mediaTypeOf(*sample) != "video/x-raw") {
        lost_ = "its appsink gets " + mediaTypeOf(*sample) + "; put a decoder before it";
        return false;
      }
      take(std::move(sample));
      return true;
    }
    if (!isAlive()) {
      return false;
    }
    if (isSilent()) {
      lost_ = "no data for two seconds";
      return false;
    }
  }
  return true;
}

cv::Mat GstStream::retrieve() {
  return sample_ ? imageOf(*sample_) : cv::Mat();
}

} // namespace dewpoint::capture
