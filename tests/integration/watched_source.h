// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_source.h"

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::tests {

/// Record of what frame sets contain, read from the tags of their images (ImageTag). Thread-safe.
class SetRecord {
public:
  /// `width`, `height`: of the images of all cameras, pixels.
  SetRecord(int width, int height) : width_(width), height_(height) {}

  /// One frame set.
  struct Entry {
    int images = 0;
    int good = 0;                     ///< images that show the ball correctly
    std::optional<std::int64_t> tick; ///< of the newest good image
  };

  void add(const FrameSet& set);
  /// Returns the recorded frame sets by their indices.
  std::map<std::int64_t, Entry> sets() const;
  /// Returns texts about images that must never occur: images of another camera, images of another
  /// size or type, and images that do not follow the one before them.
  std::vector<std::string> faults() const;
  /// Returns how many sets in succession, up to the newest one, have a good image of each camera.
  int completeSets() const;

private:
  struct Last {
    std::int64_t index = -1;
    TimeStamp time{-1};
  };
  void check(std::size_t camera, const Frame& frame);

  int width_;
  int height_;
  mutable std::mutex mutex_; ///< guards all members below
  std::map<std::int64_t, Entry> sets_;
  std::vector<std::string> faults_;
  std::map<std::size_t, Last> last_; ///< by camera
  int completeSets_ = 0;
};

/// Passes on the frame sets of a source, and records what they contain.
class WatchedSource final : public FrameSetSource {
public:
  WatchedSource(std::unique_ptr<FrameSetSource> source, std::shared_ptr<SetRecord> record)
      : source_(std::move(source)), record_(std::move(record)) {}

  std::optional<std::int64_t> frameCount() const override { return source_->frameCount(); }
  double framesPerSecond() const override { return source_->framesPerSecond(); }
  Result<FrameSetPtr> next() override {
    auto set = source_->next();
    if (set && *set) {
      record_->add(**set);
    }
    return set;
  }
  Status seek(std::int64_t frame) override { return source_->seek(frame); }
  std::int64_t droppedFrameCount() const override { return source_->droppedFrameCount(); }
  std::vector<Error> notices() const override { return source_->notices(); }

private:
  std::unique_ptr<FrameSetSource> source_;
  std::shared_ptr<SetRecord> record_;
};

} // namespace dewpoint::tests
