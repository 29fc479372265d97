// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/reversed_frames.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace dewpoint::session {
namespace {

// Judgments.

/// Bytes of the images that are held to be gone over from the last to the first.
constexpr std::size_t kBlockBytes = std::size_t{256} << 20;
constexpr std::int64_t kMostInBlock = 64; ///< frames
constexpr std::int64_t kFewestInBlock = 4;

/// The same images as if time ran the other way from a frame on.
FrameSetPtr mirrored(const FrameSet& frames, std::int64_t at, TimeStamp time) {
  auto result = std::make_shared<FrameSet>();
  result->index = 2 * at - frames.index;
  result->time = time + (time - frames.time);
  for (const FramePtr& frame : frames.frames) {
    if (!frame) {
      result->frames.emplace_back();
      continue;
    }
    auto other = std::make_shared<Frame>(*frame);
    other->index = result->index;
    other->captureTime = time + (time - frame->captureTime);
    result->frames.push_back(std::move(other));
  }
  return result;
}

} // namespace

ReversedFrames::ReversedFrames(FrameSetSource& source, std::int64_t last)
    : source_(source), last_(last), next_(last), length_(kFewestInBlock) {}

Result<FrameSetPtr> ReversedFrames::next() {
  if (next_ < 0) {
    return FrameSetPtr();
  }
  if (block_.empty() || next_ < first_) {
    if (const auto read = readBlock(); !read) {
      return tl::make_unexpected(read.error());
    }
  }
  const FrameSetPtr frames = std::move(block_.at(static_cast<std::size_t>(next_-- - first_)));
  begin_ = begin_.value_or(frames->time);
  return mirrored(*frames, last_, *begin_);
}

Status ReversedFrames::seek(std::int64_t frame) {
  next_ = last_ - frame;
  block_.clear();
  return {};
}

Status ReversedFrames::readBlock() {
  first_ = std::max<std::int64_t>(0, next_ - length_ + 1);
  block_.clear();
  if (const auto sought = source_.seek(first_); !sought) {
    return sought;
  }
  std::size_t bytes = 0;
  while (first_ + static_cast<std::int64_t>(block_.size()) <= next_) {
    auto frames = source_.next();
    if (!frames) {
      return tl::make_unexpected(frames.error());
    }
    if (!*frames) {
      return failure(ErrorCode::EndedEarly, "", "frame", "the recording ends earlier than before");
    }
    for (const FramePtr& frame : (*frames)->frames) {
      bytes += frame ? frame->image.total() * frame->image.elemSize() : 0;
    }
    block_.push_back(std::move(*frames));
  }
  const std::size_t each = std::max<std::size_t>(1, bytes / block_.size());
  length_ = std::clamp(static_cast<std::int64_t>(kBlockBytes / each), kFewestInBlock, kMostInBlock);
  return {};
}

} // namespace dewpoint::session
