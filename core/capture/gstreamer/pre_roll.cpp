// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/pre_roll.h"

#include "core/capture/gstreamer/gst_image.h"

#include <algorithm>
#include <gst/gst.h>

namespace dewpoint::capture {

namespace {

bool isKeyImage(const EncodedImage& image) {
  return !GST_BUFFER_FLAG_IS_SET(gst_sample_get_buffer(image.sample.get()),
                                 GST_BUFFER_FLAG_DELTA_UNIT);
}

std::size_t bytesOf(const EncodedImage& image) {
  return gst_buffer_get_size(gst_sample_get_buffer(image.sample.get()));
}

/// A copy of the bytes: a driver has few buffers, and waits for those that are kept.
EncodedImage copyOf(const EncodedImage& image) {
  GstSample* original = image.sample.get();
  GstBuffer* bytes = gst_buffer_copy_deep(gst_sample_get_buffer(original));
  const std::shared_ptr<GstSample> copy(gst_sample_new(bytes, gst_sample_get_caps(original),
                                                       gst_sample_get_segment(original), nullptr),
                                        gst_sample_unref);
  gst_buffer_unref(bytes); // the sample keeps it
  return {copy, image.captureInstant};
}

} // namespace

void PreRoll::add(const EncodedImage& image) {
  if (std::string format = storedFormatOf(*image.sample); format != format_) {
    clear();
    format_ = std::move(format);
  }
  if (images_.empty() && !isKeyImage(image)) {
    return;
  }
  images_.push_back(copyOf(image));
  bytes_ += bytesOf(image);
  // The oldest image that is needed is the last one that stands for itself before the length.
  const auto begin =
      image.captureInstant.time -
      std::chrono::duration_cast<std::chrono::steady_clock::duration>(limits_.duration);
  const auto isNeeded = [&] {
    const auto next = std::find_if(images_.begin() + 1, images_.end(), isKeyImage);
    return next == images_.end() || next->captureInstant.time > begin;
  };
  while (images_.size() > 1 && !isNeeded()) {
    dropFirstGroup();
    shortened_ = false;
  }
  while (bytes_ > limits_.maxBytes) {
    dropFirstGroup();
    shortened_ = true;
  }
}

void PreRoll::dropFirstGroup() {
  do {
    bytes_ -= bytesOf(images_.front());
    images_.pop_front();
  } while (!images_.empty() && !isKeyImage(images_.front()));
}

void PreRoll::clear() {
  images_.clear();
  bytes_ = 0;
  shortened_ = false;
}

PreRollStatus PreRoll::status() const {
  PreRollStatus status;
  status.imageCount = images_.size();
  status.byteCount = bytes_;
  status.isShortened = shortened_;
  if (!images_.empty()) {
    status.spanSeconds = std::chrono::duration<double>(images_.back().captureInstant.time -
                                                       images_.front().captureInstant.time)
                             .count();
  }
  return status;
}

} // namespace dewpoint::capture
