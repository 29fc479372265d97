// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/stored_stream.h"

#include "core/capture/gstreamer/gst_image.h"
#include "core/capture/gstreamer/pipeline_text.h"

#include <fmt/format.h>

#include <gst/app/gstappsink.h>
#include <gst/gst.h>
#include <utility>

namespace dewpoint::capture {

namespace {
constexpr GstClockTime kImagePatience = 20 * GST_SECOND; ///< a disk may be slow
} // namespace

StoredStream::StoredStream(GstElementPtr pipeline, std::filesystem::path video, std::string field)
    : pipeline_(std::move(pipeline)), video_(std::move(video)), field_(std::move(field)) {
  sink_ = gst_bin_get_by_name(GST_BIN(pipeline_.get()), kImageSinkName);
  gst_object_unref(sink_); // the pipeline keeps it
}

Result<StoredStream> StoredStream::open(const std::filesystem::path& video,
                                        const std::string& field) {
  std::error_code problem;
  if (!std::filesystem::exists(video, problem)) {
    return failure(ErrorCode::FileMissing, video.string(), field, "");
  }
  std::string reason;
  GstElementPtr pipeline = makePipeline(storedPipelineText(video.string()), reason);
  if (!pipeline ||
      gst_element_set_state(pipeline.get(), GST_STATE_PLAYING) == GST_STATE_CHANGE_FAILURE) {
    return failure(ErrorCode::FileUnreadable, video.string(), field, reason);
  }
  return StoredStream(std::move(pipeline), video, field);
}

Result<cv::Mat> StoredStream::read(std::int64_t number) {
  cv::Mat image;
  for (; next_ <= number; ++next_) {
    const GstSamplePtr sample(gst_app_sink_try_pull_sample(GST_APP_SINK(sink_), kImagePatience));
    if (!sample) {
      break;
    }
    if (next_ == number) {
      image = imageOf(*sample);
    }
  }
  if (image.empty()) {
    return failure(ErrorCode::EndedEarly, video_.string(), field_,
                   fmt::format("image {} cannot be read", number + 1));
  }
  return image;
}

} // namespace dewpoint::capture
