// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/frames/recorded_frames.h"

#include "core/session/frames/frame_previews.h"

#include <algorithm>
#include <list>
#include <map>

namespace dewpoint::session {
namespace {

/// Frames decoded before the one asked for when the numbers fall: the next ones asked for.
constexpr std::int64_t kReadBehind = 8;
/// Steps back within this many frames are somebody going backwards, others are jumps.
constexpr std::int64_t kStepBack = 4;
/// This part of the memory is for small pictures.
constexpr std::size_t kPreviewShare = 2;

class RecordedFrames final : public FrameCache {
public:
  RecordedFrames(FrameSetSource& source, std::size_t maxBytes)
      : source_(source), most_(maxBytes), previews_(maxBytes / kPreviewShare) {}

  void add(const FrameSetPtr& frames) override {
    if (frames) {
      previews_.add(*frames);
    }
    if (frames && found_.find(frames->index) == found_.end()) {
      order_.push_front(frames);
      found_[frames->index] = order_.begin();
      bytes_ += bytesOf(*frames);
      while (bytes_ > most_ - previews_.maxBytes() && order_.size() > 1) {
        bytes_ -= bytesOf(*order_.back());
        found_.erase(order_.back()->index);
        order_.pop_back();
      }
    }
  }

  Result<FrameSetPtr> at(std::int64_t frame) override {
    const std::int64_t last = std::exchange(lastRequested_, frame);
    if (const auto known = found_.find(frame); known != found_.end()) {
      order_.splice(order_.begin(), order_, known->second);
      return order_.front();
    }
    if (frame < 0 || frame > newestFrame()) {
      return FrameSetPtr();
    }
    const bool backwards = frame < last && last - frame <= kStepBack;
    const std::int64_t begin = backwards ? std::max<std::int64_t>(0, frame - kReadBehind) : frame;
    if (const auto sought = source_.seek(begin); !sought) {
      return tl::make_unexpected(sought.error());
    }
    FrameSetPtr wanted;
    for (std::int64_t k = begin; k <= frame; ++k) {
      auto taken = source_.next();
      if (!taken) {
        return taken;
      }
      wanted = *taken;
      add(wanted);
    }
    return wanted;
  }

  FrameSetPtr previewAt(std::int64_t frame, bool& exact) override {
    exact = found_.contains(frame);
    return exact ? *found_.at(frame) : previews_.at(frame);
  }

  std::int64_t oldestFrame() const override { return 0; }
  std::int64_t newestFrame() const override { return source_.frameCount().value_or(0) - 1; }
  std::size_t memoryBytes() const override { return bytes_ + previews_.memoryBytes(); }

private:
  FrameSetSource& source_;
  std::size_t most_;
  FramePreviews previews_;
  std::size_t bytes_ = 0;
  std::list<FrameSetPtr> order_; ///< the one used last first
  std::map<std::int64_t, std::list<FrameSetPtr>::iterator> found_;
  std::int64_t lastRequested_ = -1;
};

} // namespace

std::unique_ptr<FrameCache> makeRecordedFrameCache(FrameSetSource& source, std::size_t maxBytes) {
  return std::make_unique<RecordedFrames>(source, maxBytes);
}

} // namespace dewpoint::session
