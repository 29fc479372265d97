// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_source.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace dewpoint::session {

/// Source that delivers the frames of a recording from frame `last` back to the first, as if time
/// ran backward. Frame `last` is delivered with its own number and time; the numbers and times of
/// the frames delivered after it increase. Frames are read in blocks because videos are slow to
/// read backward.
class ReversedFrames final : public FrameSetSource {
public:
  ReversedFrames(FrameSetSource& source, std::int64_t last);

  std::optional<std::int64_t> frameCount() const override { return last_ + 1; }
  double framesPerSecond() const override { return source_.framesPerSecond(); }
  Result<FrameSetPtr> next() override;
  Status seek(std::int64_t frame) override;
  /// Returns the frame number, in the recording, of the frame that next() delivers next; -1 if none
  /// is left.
  std::int64_t nextFrame() const { return next_; }

private:
  Status readBlock();

  FrameSetSource& source_;
  std::int64_t last_;
  std::int64_t next_;
  std::int64_t first_ = 0; ///< first frame of the block
  std::int64_t length_;    ///< length of the next block, in frames
  std::vector<FrameSetPtr> block_;
  std::optional<TimeStamp> begin_; ///< time of frame `last_`
};

} // namespace dewpoint::session
