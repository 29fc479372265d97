// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/frames/live_frames.h"

#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace dewpoint::session {
namespace {

/// Of JPEG; below it the edges of small targets begin to blur.
constexpr int kKeptQuality = 92;
/// This share of the memory holds frames as they came; what is older is compressed.
constexpr std::size_t kUncompressedDivisor = 4; // one quarter

struct CompressedFrame {
  std::int64_t index = 0;
  TimeStamp captureTime{};
  std::vector<std::uint8_t> bytes; ///< a JPEG file; empty: the camera delivered nothing
};

/// One frame set: as it came, or packed.
struct CachedFrame {
  std::int64_t index = 0;
  TimeStamp time{};
  FrameSetPtr raw;
  std::vector<CompressedFrame> packed;
  std::size_t bytes = 0;
};

std::vector<CompressedFrame> compress(const FrameSet& frames) {
  std::vector<CompressedFrame> packed;
  for (const FramePtr& frame : frames.frames) {
    CompressedFrame& one = packed.emplace_back();
    if (frame && !frame->image.empty()) {
      one.index = frame->index;
      one.captureTime = frame->captureTime;
      cv::imencode(".jpg", frame->image, one.bytes, {cv::IMWRITE_JPEG_QUALITY, kKeptQuality});
    }
  }
  return packed;
}

FrameSetPtr decompress(const CachedFrame& kept) {
  auto set = std::make_shared<FrameSet>();
  set->index = kept.index;
  set->time = kept.time;
  for (const CompressedFrame& packed : kept.packed) {
    if (packed.bytes.empty()) {
      set->frames.push_back(nullptr);
      continue;
    }
    set->frames.push_back(std::make_shared<const Frame>(
        Frame{packed.index, packed.captureTime, cv::imdecode(packed.bytes, cv::IMREAD_COLOR)}));
  }
  return set;
}

class LiveFrames final : public LiveFrameCache {
public:
  explicit LiveFrames(std::size_t maxBytes) : most_(maxBytes) {
    compressor_ = std::jthread([this](const std::stop_token& stop) { compressOld(stop); });
  }

  void add(const FrameSetPtr& frames) override {
    const std::lock_guard lock(mutex_);
    if (!frames || (!kept_.empty() && frames->index <= kept_.back().index)) {
      return;
    }
    kept_.push_back({frames->index, frames->time, frames, {}, bytesOf(*frames)});
    bytes_ += kept_.back().bytes;
    rawBytes_ += kept_.back().bytes;
    while (bytes_ > most_ && kept_.size() > 1) {
      forgetOldest();
    }
    if (rawBytes_ > most_ / kUncompressedDivisor) {
      wake_.notify_one();
    }
  }

  Result<FrameSetPtr> at(std::int64_t frame) override {
    CachedFrame found;
    {
      const std::lock_guard lock(mutex_);
      const auto entry = find(frame);
      if (entry == kept_.end()) {
        return FrameSetPtr();
      }
      found = *entry;
    }
    if (found.raw) {
      return found.raw;
    }
    try {
      return decompress(found);
    } catch (const std::exception& problem) {
      return failure(ErrorCode::FileUnreadable, "", "history", problem.what());
    }
  }

  FrameSetPtr previewAt(std::int64_t frame, bool& exact) override {
    exact = true;
    return at(frame).value_or(FrameSetPtr());
  }

  std::int64_t oldestFrame() const override {
    const std::lock_guard lock(mutex_);
    return kept_.empty() ? 0 : kept_.front().index;
  }
  std::int64_t newestFrame() const override {
    const std::lock_guard lock(mutex_);
    return kept_.empty() ? -1 : kept_.back().index;
  }
  std::size_t memoryBytes() const override {
    const std::lock_guard lock(mutex_);
    return bytes_;
  }
  void clear() override {
    const std::lock_guard lock(mutex_);
    kept_.clear();
    bytes_ = 0;
    rawBytes_ = 0;
  }

private:
  std::deque<CachedFrame>::iterator find(std::int64_t frame) {
    const auto entry = std::lower_bound(
        kept_.begin(), kept_.end(), frame,
        [](const CachedFrame& kept, std::int64_t index) { return kept.index < index; });
    return entry != kept_.end() && entry->index == frame ? entry : kept_.end();
  }

  void forgetOldest() {
    bytes_ -= kept_.front().bytes;
    rawBytes_ -= kept_.front().raw ? kept_.front().bytes : 0;
    kept_.pop_front();
  }

  /// The oldest that is not packed; null when there is room for all that are not.
  FrameSetPtr oldestUncompressed() {
    const auto entry =
        rawBytes_ > most_ / kUncompressedDivisor
            ? std::find_if(kept_.begin(), kept_.end(),
                           [](const CachedFrame& kept) { return kept.raw != nullptr; })
            : kept_.end();
    return entry != kept_.end() ? entry->raw : nullptr;
  }

  void compressOld(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      FrameSetPtr next;
      {
        std::unique_lock lock(mutex_);
        wake_.wait(lock, stop, [&] { return (next = oldestUncompressed()) != nullptr; });
      }
      if (next) {
        replace(next);
      }
    }
  }

  void replace(const FrameSetPtr& raw) {
    std::vector<CompressedFrame> packed;
    try {
      packed = compress(*raw);
    } catch (const std::exception&) {
      packed.assign(raw->frames.size(), {}); // shown as missing
    }
    const std::lock_guard lock(mutex_);
    const auto entry = find(raw->index);
    if (entry == kept_.end() || entry->raw != raw) {
      return; // forgotten meanwhile
    }
    bytes_ -= entry->bytes;
    rawBytes_ -= entry->bytes;
    entry->raw = nullptr;
    entry->packed = std::move(packed);
    entry->bytes = 0;
    for (const CompressedFrame& frame : entry->packed) {
      entry->bytes += frame.bytes.size();
    }
    bytes_ += entry->bytes;
  }

  std::size_t most_;
  mutable std::mutex mutex_;
  std::condition_variable_any wake_;
  std::deque<CachedFrame> kept_; ///< by rising number
  std::size_t bytes_ = 0;
  std::size_t rawBytes_ = 0;
  std::jthread compressor_; // last: joined before the rest goes
};

} // namespace

std::unique_ptr<LiveFrameCache> makeLiveFrameCache(std::size_t maxBytes) {
  return std::make_unique<LiveFrames>(maxBytes);
}

} // namespace dewpoint::session
