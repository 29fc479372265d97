// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/encoded_feed.h"

#include <utility>

namespace dewpoint::capture {

void EncodedFeed::put(const EncodedImage& image) {
  std::scoped_lock lock(mutex_);
  ++images_;
  endTime_.reset();
  if (receiver_) {
    receiver_(image);
  } else if (preRoll_) {
    preRoll_->add(image);
  }
}

void EncodedFeed::markEnded() {
  std::scoped_lock lock(mutex_);
  if (preRoll_) {
    preRoll_->clear(); // what comes next does not continue it
  }
  if (!endTime_) {
    endTime_ = Clock::now();
  }
}

void EncodedFeed::connect(Receiver receiver) {
  std::scoped_lock lock(mutex_);
  receiver_ = std::move(receiver);
  if (receiver_ && preRoll_) {
    for (const EncodedImage& image : preRoll_->images()) {
      receiver_(image);
    }
    preRoll_->clear();
  }
}

void EncodedFeed::setPreRoll(const PreRollLimits& limits) {
  std::scoped_lock lock(mutex_);
  preRoll_.reset();
  if (limits.duration.count() > 0.0) {
    preRoll_.emplace(limits);
  }
}

PreRollStatus EncodedFeed::preRoll() const {
  std::scoped_lock lock(mutex_);
  return preRoll_ ? preRoll_->status() : PreRollStatus();
}

std::optional<EncodedFeed::Clock::time_point> EncodedFeed::preRollBegin() const {
  std::scoped_lock lock(mutex_);
  const bool hasAny = preRoll_ && !preRoll_->images().empty();
  return hasAny ? std::optional(preRoll_->images().front().captureInstant.time) : std::nullopt;
}

void EncodedFeed::disconnect() {
  connect({});
}

std::int64_t EncodedFeed::imageCount() const {
  std::scoped_lock lock(mutex_);
  return images_;
}

std::optional<EncodedFeed::Clock::time_point> EncodedFeed::endTime() const {
  std::scoped_lock lock(mutex_);
  return endTime_;
}

} // namespace dewpoint::capture
