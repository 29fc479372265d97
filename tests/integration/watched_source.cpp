// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/integration/watched_source.h"

#include "tests/integration/image_tag.h"

#include <fmt/format.h>

#include <algorithm>

namespace dewpoint::tests {

void SetRecord::check(std::size_t camera, const Frame& frame) {
  const auto fault = [&](const std::string& words) {
    faults_.push_back(fmt::format("camera {}, image {}: {}", camera + 1, frame.index, words));
  };
  if (frame.image.type() != CV_8UC3 || frame.image.cols != width_ || frame.image.rows != height_) {
    fault(fmt::format("{} x {}, type {}", frame.image.cols, frame.image.rows, frame.image.type()));
  }
  Last& last = last_[camera];
  if (frame.index <= last.index || frame.captureTime <= last.time) {
    fault(fmt::format("follows image {}", last.index));
  }
  last = {frame.index, frame.captureTime};
  const auto tag = readTag(frame.image);
  if (!tag) {
    fault("has no tag");
  } else if (tag->camera != static_cast<int>(camera)) {
    fault(fmt::format("is of camera {}", tag->camera + 1));
  }
}

void SetRecord::add(const FrameSet& set) {
  Entry entry;
  std::scoped_lock lock(mutex_);
  for (std::size_t k = 0; k < set.frames.size(); ++k) {
    if (!set.frames[k]) {
      continue;
    }
    ++entry.images;
    check(k, *set.frames[k]);
    const auto tag = readTag(set.frames[k]->image);
    if (tag && tag->isGood) {
      ++entry.good;
      entry.tick = std::max(entry.tick.value_or(tag->tick), tag->tick);
    }
  }
  completeSets_ = entry.good == static_cast<int>(set.frames.size()) ? completeSets_ + 1 : 0;
  sets_[set.index] = entry;
}

std::map<std::int64_t, SetRecord::Entry> SetRecord::sets() const {
  std::scoped_lock lock(mutex_);
  return sets_;
}

std::vector<std::string> SetRecord::faults() const {
  std::scoped_lock lock(mutex_);
  return faults_;
}

int SetRecord::completeSets() const {
  std::scoped_lock lock(mutex_);
  return completeSets_;
}

} // namespace dewpoint::tests
