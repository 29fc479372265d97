// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/stream_recording.h"

#include "core/base/growing_file.h"
#include "core/capture/capture_times.h"
#include "core/capture/gstreamer/gst_image.h"
#include "core/capture/gstreamer/gst_library.h"
#include "core/capture/gstreamer/pipeline_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <deque>
#include <gst/app/gstappsrc.h>
#include <gst/gst.h>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace dewpoint::capture {

using namespace std::chrono_literals;

namespace {

// Judgments.
constexpr std::uint64_t kMostWaitingBytes = 256ULL << 20;
/// Of images that wait to be written: what a killed program loses. A last second is for the rest.
constexpr std::chrono::seconds kLongestWaiting = 1s;
constexpr auto kStopPatience = 800ms;
/// How long the images before the start may take to be written, before live images are dropped.
constexpr std::chrono::seconds kPreRollPatience = 5s;

/// Width and height of a sample's images for a sentence.
std::string sizeOf(GstSample& sample) {
  int width = 0;
  int height = 0;
  if (GstCaps* caps = gst_sample_get_caps(&sample)) {
    const GstStructure* structure = gst_caps_get_structure(caps, 0);
    gst_structure_get_int(structure, "width", &width);
    gst_structure_get_int(structure, "height", &height);
  }
  return fmt::format("{} x {}", width, height);
}

/// The pixel format of a raw image; empty if it is none.
std::string rawFormatOf(GstSample& sample) {
  GstCaps* caps = gst_sample_get_caps(&sample);
  const char* format = caps != nullptr && gst_caps_get_size(caps) > 0
                           ? gst_structure_get_string(gst_caps_get_structure(caps, 0), "format")
                           : nullptr;
  return format != nullptr ? format : "";
}

bool isOfSeveralImages(const std::string& mediaType) {
  return mediaType != "image/jpeg" && mediaType != "image/png" && mediaType != "video/x-raw";
}

} // namespace

/// Receives images, and writes them. Its pipeline calls it from threads of its own.
struct StreamRecording::Writer {
  StreamFiles files;
  RawStorage raw = RawStorage::Jpeg;
  Clock::time_point zero;
  GstClockTime begin = 0; ///< of the take; earlier images are the pre-roll
  std::string field;

  /// Used only by the thread that passes images on, or after it was disconnected.
  GstElementPtr pipeline;
  GstElement* source = nullptr;
  std::string format;
  bool isInter = false;  ///< an image may need those before it
  bool needsKey = false; ///< images are left out until the next one that stands for itself

  mutable std::mutex mutex; ///< guards all members below
  std::condition_variable ended;
  bool hasEnded = false;
  bool isStopped = false;
  std::optional<GrowingFile> table;
  struct WaitingImage {
    GstClockTime time = 0;
    CaptureInstant captured;
  };
  std::deque<WaitingImage> waiting; ///< images on their way to the file
  std::vector<std::int64_t> stamps; ///< of the images in the file
  bool isChanged = false;           ///< images are stored with other pixels
  std::int64_t received = 0;
  std::int64_t written = 0;
  std::int64_t preRoll = 0; ///< of them, captured before the start
  TimeOrigin lastOrigin = TimeOrigin::Arrival;
  GstClockTime firstTime = GST_CLOCK_TIME_NONE;
  GstClockTime lastTime = 0;
  GstClockTime lastPushed = GST_CLOCK_TIME_NONE;
  std::optional<Error> problem;

  void setProblem(const std::filesystem::path& file, std::string detail,
                  ErrorCode code = ErrorCode::FileUnwritable);
  /// Whether nothing more can be written; needs the mutex.
  bool isBroken() const { return problem && problem->code == ErrorCode::FileUnwritable; }
  bool hasFailed() const;
  void receive(const std::shared_ptr<Writer>& self, const EncodedImage& image);
  bool start(const std::shared_ptr<Writer>& self, GstSample& sample);
  bool openTable();
  bool hasRoom(GstClockTime time) const;
  void writeTime(GstClockTime time);
  void finish();

  static GstPadProbeReturn onImage(GstPad* pad, GstPadProbeInfo* info, gpointer data);
  static GstBusSyncReply onMessage(GstBus* bus, GstMessage* message, gpointer data);
};

void StreamRecording::Writer::setProblem(const std::filesystem::path& file, std::string detail,
                                         ErrorCode code) {
  std::scoped_lock lock(mutex);
  if (!isBroken()) {
    problem = Error{code, file.string(), field, std::move(detail)};
  }
  ended.notify_all();
}

bool StreamRecording::Writer::hasFailed() const {
  std::scoped_lock lock(mutex);
  return isBroken();
}

bool StreamRecording::Writer::openTable() {
  auto created = GrowingFile::create(files.timesFile);
  const Status begun =
      created ? created->append(fmt::format("{}\nframe,time_s,origin\n", kRecordedTimesHeading))
              : tl::make_unexpected(created.error());
  if (!begun) {
    setProblem(files.timesFile, begun.error().detail);
    return false;
  }
  std::scoped_lock lock(mutex);
  table.emplace(std::move(*created));
  return true;
}

bool StreamRecording::Writer::start(const std::shared_ptr<Writer>& self, GstSample& sample) {
  const std::string mediaType = mediaTypeOf(sample);
  std::string reason;
  pipeline = makePipeline(
      recordingPipelineText(mediaType, raw == RawStorage::Lossless, files.videoFile.string()),
      reason);
  if (!pipeline) {
    setProblem(files.videoFile,
               fmt::format("a stream of {} cannot be recorded: {}", mediaType, reason));
    return false;
  }
  if (!openTable()) {
    return false;
  }
  const auto element = [&](const char* name) {
    GstElement* found = gst_bin_get_by_name(GST_BIN(pipeline.get()), name);
    gst_object_unref(found); // the pipeline keeps it
    return found;
  };
  source = element("source");
  gst_app_src_set_caps(GST_APP_SRC(source), gst_sample_get_caps(&sample));
  const auto release = [](gpointer data) { delete static_cast<std::shared_ptr<Writer>*>(data); };
  GstIterator* pads = gst_element_iterate_sink_pads(element("muxer"));
  GValue item = G_VALUE_INIT;
  if (gst_iterator_next(pads, &item) == GST_ITERATOR_OK) {
    gst_pad_add_probe(static_cast<GstPad*>(g_value_get_object(&item)), GST_PAD_PROBE_TYPE_BUFFER,
                      &Writer::onImage, new std::shared_ptr<Writer>(self), release);
    g_value_unset(&item);
  }
  gst_iterator_free(pads);
  GstBus* bus = gst_element_get_bus(pipeline.get());
  gst_bus_set_sync_handler(bus, &Writer::onMessage, new std::shared_ptr<Writer>(self), release);
  gst_object_unref(bus);
  format = storedFormatOf(sample);
  {
    std::scoped_lock lock(mutex);
    isChanged = mediaType == "video/x-raw" &&
                (raw == RawStorage::Jpeg || !isStoredLossless(rawFormatOf(sample)));
  }
  isInter = isOfSeveralImages(mediaType);
  needsKey = isInter;
  if (gst_element_set_state(pipeline.get(), GST_STATE_PLAYING) == GST_STATE_CHANGE_FAILURE) {
    setProblem(files.videoFile, "the video cannot be created");
    return false;
  }
  return true;
}

bool StreamRecording::Writer::hasRoom(GstClockTime time) const {
  if (time < begin) {
    return true; // its memory is limited already
  }
  std::scoped_lock lock(mutex);
  // The pre-roll comes all at once, and takes its time.
  const bool isPreRoll = !waiting.empty() && waiting.front().time < begin;
  const GstClockTime since = waiting.empty() ? time : std::max(waiting.front().time, begin);
  const bool isLate = time > since && std::chrono::nanoseconds(time - since) >
                                          (isPreRoll ? kPreRollPatience : kLongestWaiting);
  return !isLate && gst_app_src_get_current_level_bytes(GST_APP_SRC(source)) < kMostWaitingBytes;
}

void StreamRecording::Writer::receive(const std::shared_ptr<Writer>& self,
                                      const EncodedImage& image) {
  if (image.captureInstant.time < zero) {
    return;
  }
  GstBuffer* original = gst_sample_get_buffer(image.sample.get());
  const bool isKey = !GST_BUFFER_FLAG_IS_SET(original, GST_BUFFER_FLAG_DELTA_UNIT);
  {
    std::scoped_lock lock(mutex);
    if (isStopped || (received == 0 && !isKey)) { // it begins with a key frame
      return;
    }
    ++received;
  }
  if (hasFailed() || (!pipeline && !start(self, *image.sample))) {
    return;
  }
  if (storedFormatOf(*image.sample) != format) {
    setProblem(
        files.videoFile,
        fmt::format("the camera's format changed during the recording, images of {} are left "
                    "out",
                    sizeOf(*image.sample)),
        ErrorCode::Mismatch);
    needsKey = isInter;
    return;
  }
  GstClockTime time =
      static_cast<GstClockTime>(std::chrono::nanoseconds(image.captureInstant.time - zero).count());
  if ((needsKey && !isKey) || !hasRoom(time)) {
    needsKey = isInter;
    return;
  }
  needsKey = false;
  {
    std::scoped_lock lock(mutex);
    // Tables of capture times have microseconds.
    constexpr GstClockTime kLeast = 1000;
    time = GST_CLOCK_TIME_IS_VALID(lastPushed) ? std::max(time, lastPushed + kLeast) : time;
    lastPushed = time;
    waiting.push_back({time, image.captureInstant});
  }
  GstBuffer* buffer = gst_buffer_copy(original); // shares the bytes
  GST_BUFFER_PTS(buffer) = time;
  GST_BUFFER_DTS(buffer) = GST_CLOCK_TIME_NONE;
  GST_BUFFER_DURATION(buffer) = GST_CLOCK_TIME_NONE;
  gst_app_src_push_buffer(GST_APP_SRC(source), buffer);
}

GstPadProbeReturn StreamRecording::Writer::onImage(GstPad*, GstPadProbeInfo* info, gpointer data) {
  auto& writer = **static_cast<std::shared_ptr<Writer>*>(data);
  const GstBuffer* buffer = GST_PAD_PROBE_INFO_BUFFER(info);
  if (GST_CLOCK_TIME_IS_VALID(GST_BUFFER_PTS(buffer))) {
    writer.writeTime(GST_BUFFER_PTS(buffer));
  }
  return GST_PAD_PROBE_OK;
}

void StreamRecording::Writer::writeTime(GstClockTime time) {
  std::unique_lock lock(mutex);
  std::int64_t stamp = -1;
  while (!waiting.empty() && waiting.front().time <= time) {
    lastOrigin = waiting.front().captured.origin;
    stamp = waiting.front().captured.imageId;
    waiting.pop_front();
  }
  if (!table || isBroken()) {
    return;
  }
  constexpr double kNanosecond = 1e-9;
  const Status appended =
      table->append(fmt::format("{},{:.6f},{}\n", written, static_cast<double>(time) * kNanosecond,
                                timeOriginName(lastOrigin)));
  if (!appended) {
    lock.unlock();
    setProblem(files.timesFile, appended.error().detail);
    return;
  }
  ++written;
  stamps.push_back(stamp);
  preRoll += time < begin ? 1 : 0;
  firstTime = GST_CLOCK_TIME_IS_VALID(firstTime) ? firstTime : time;
  lastTime = time;
}

GstBusSyncReply StreamRecording::Writer::onMessage(GstBus*, GstMessage* message, gpointer data) {
  auto& writer = **static_cast<std::shared_ptr<Writer>*>(data);
  if (GST_MESSAGE_TYPE(message) == GST_MESSAGE_ERROR) {
    writer.setProblem(writer.files.videoFile, gstMessageErrorText(message));
  } else if (GST_MESSAGE_TYPE(message) == GST_MESSAGE_EOS) {
    std::scoped_lock lock(writer.mutex);
    writer.hasEnded = true;
    writer.ended.notify_all();
  }
  gst_message_unref(message);
  return GST_BUS_DROP;
}

void StreamRecording::Writer::finish() {
  {
    std::scoped_lock lock(mutex);
    isStopped = true;
  }
  if (pipeline && !hasFailed()) {
    gst_app_src_end_of_stream(GST_APP_SRC(source));
    std::unique_lock lock(mutex);
    ended.wait_for(lock, kStopPatience, [&] { return hasEnded || isBroken(); });
  }
  pipeline.reset();
  std::unique_lock lock(mutex);
  if (!table) {
    return;
  }
  Status closed = !isBroken() && hasEnded
                      ? table->append(fmt::format("{} {}\n", kRecordedTimesEnd, written))
                      : Status();
  closed = closed.and_then([&] { return table->close(); });
  table.reset();
  lock.unlock();
  if (!closed) {
    setProblem(files.timesFile, closed.error().detail);
  }
}

StreamRecording::StreamRecording(EncodedFeedPtr feed, StreamFiles files, RawStorage raw,
                                 Clock::time_point zero, std::string field,
                                 std::optional<Clock::time_point> begin)
    : feed_(std::move(feed)), writer_(std::make_shared<Writer>()) {
  writer_->files = std::move(files);
  writer_->raw = raw;
  writer_->zero = zero;
  writer_->begin = static_cast<GstClockTime>(
      std::max<std::int64_t>(0, std::chrono::nanoseconds(begin.value_or(zero) - zero).count()));
  writer_->field = std::move(field);
  feed_->connect([writer = writer_](const EncodedImage& image) { writer->receive(writer, image); });
}

StreamRecording::~StreamRecording() {
  stop();
}

RecordedCounts StreamRecording::counts() const {
  RecordedCounts counts;
  std::scoped_lock lock(writer_->mutex);
  const Writer& writer = *writer_;
  counts.imageCount = writer.written;
  counts.preRollImageCount = writer.preRoll;
  counts.hasChangedPixels = writer.isChanged;
  counts.droppedImageCount = writer.received - writer.written -
                             (stopped_ || writer.isBroken() // what waited is lost
                                  ? 0
                                  : static_cast<std::int64_t>(writer.waiting.size()));
  if (writer.written > 1 && writer.lastTime > writer.firstTime) {
    counts.framesPerSecond = static_cast<double>(writer.written - 1) * 1e9 /
                             static_cast<double>(writer.lastTime - writer.firstTime);
  }
  counts.origin = writer.lastOrigin;
  counts.problem = writer.problem;
  std::error_code none;
  const auto size = std::filesystem::file_size(writer.files.videoFile, none);
  counts.byteCount = none ? 0 : static_cast<std::int64_t>(size);
  return counts;
}

std::vector<std::int64_t> StreamRecording::imageStamps() const {
  std::scoped_lock lock(writer_->mutex);
  return writer_->stamps;
}

void StreamRecording::stop() {
  if (stopped_) {
    return;
  }
  feed_->disconnect();
  writer_->finish();
  stopped_ = true;
}

} // namespace dewpoint::capture
