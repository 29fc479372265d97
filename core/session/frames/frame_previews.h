// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

namespace dewpoint::session {

/// Small images (previews) of past frames, shown while the full images are being decoded, which can
/// take long in a video. When the memory limit is reached, every second preview is removed. The
/// nearest earlier preview is then shown instead of a removed one.
class FramePreviews {
public:
  explicit FramePreviews(std::size_t maxBytes) : maxBytes_(maxBytes) {}

  /// Adds previews of the images of a frame.
  void add(const FrameSet& frames);
  /// Returns previews scaled up to the size of the frame's images; null if there is no preview at
  /// or shortly before this frame.
  FrameSetPtr at(std::int64_t frame) const;
  std::size_t memoryBytes() const { return bytes_; }
  std::size_t maxBytes() const { return maxBytes_; }

private:
  struct Thumbnail {
    std::vector<std::uint8_t> jpeg; ///< empty: the camera delivered no image
    int width = 0;                  ///< width of the frame, pixels
    int height = 0;
  };
  struct Entry {
    TimeStamp time{};
    std::vector<Thumbnail> cameras;
    std::size_t bytes = 0;
  };
  void thin();

  std::size_t maxBytes_;
  std::size_t bytes_ = 0;
  std::int64_t spacing_ = 1; ///< interval between stored frames, in frames
  std::map<std::int64_t, Entry> entries_;
};

} // namespace dewpoint::session
