// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace dewpoint::session {

/// Small pictures of the frames that went by, to be shown while the true ones are decoded: to reach
/// a frame of a video, all frames since its last key frame must be. When the memory is used up,
/// every second one is removed, and the nearest one before is shown in its place.
class FramePreviews {
public:
  explicit FramePreviews(std::size_t mostBytes) : most_(mostBytes) {}

  void add(const FrameSet& frames);
  /// Scaled up to the size of the frame; null when none is near.
  FrameSetPtr at(std::int64_t frame) const;
  std::size_t bytes() const { return bytes_; }
  std::size_t most() const { return most_; }

private:
  struct Small {
    std::vector<std::uint8_t> jpeg; ///< empty: the camera delivered nothing
    int width = 0;                  ///< of the frame, pixels
    int height = 0;
  };
  struct Entry {
    TimeStamp time{};
    std::vector<Small> cameras;
    std::size_t bytes = 0;
  };
  void thin();

  std::size_t most_;
  std::size_t bytes_ = 0;
  std::int64_t spacing_ = 1; ///< frames between those that are kept
  std::map<std::int64_t, Entry> entries_;
};

} // namespace dewpoint::session
