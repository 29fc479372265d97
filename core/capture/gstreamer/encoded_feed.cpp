// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/encoded_feed.h"

#include <utility>

namespace dewpoint::capture {

void EncodedFeed::put(const EncodedImage& image) {
  std::scoped_lock lock(mutex_);
  ++images_;
  endedSince_.reset();
  if (receiver_) {
    receiver_(image);
  }
}

void EncodedFeed::setEnded() {
  std::scoped_lock lock(mutex_);
  if (!endedSince_) {
    endedSince_ = Clock::now();
  }
}

void EncodedFeed::connect(Receiver receiver) {
  std::scoped_lock lock(mutex_);
  receiver_ = std::move(receiver);
}

void EncodedFeed::disconnect() {
  connect({});
}

std::int64_t EncodedFeed::imageCount() const {
  std::scoped_lock lock(mutex_);
  return images_;
}

std::optional<EncodedFeed::Clock::time_point> EncodedFeed::endedSince() const {
  std::scoped_lock lock(mutex_);
  return endedSince_;
}

} // namespace dewpoint::capture
