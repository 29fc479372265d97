// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_source.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace dewpoint::session {

/// The frames of a recording from a last one down to the first, as if time ran the other way from
/// there on: numbers and times of the last one stay, and rise. Read in blocks, since videos are
/// made to be read forward.
class ReversedFrames final : public FrameSetSource {
public:
  ReversedFrames(FrameSetSource& source, std::int64_t last);

  std::optional<std::int64_t> frameCount() const override { return last_ + 1; }
  double framesPerSecond() const override { return source_.framesPerSecond(); }
  Result<FrameSetPtr> next() override;
  Status seek(std::int64_t frame) override;
  /// The recording's own number of the frame that comes next; -1: none is left.
  std::int64_t nextFrame() const { return next_; }

private:
  Status readBlock();

  FrameSetSource& source_;
  std::int64_t last_;
  std::int64_t next_;
  std::int64_t first_ = 0; ///< of the block
  std::int64_t length_;    ///< of the next block
  std::vector<FrameSetPtr> block_;
  std::optional<TimeStamp> begin_; ///< of the last frame
};

} // namespace dewpoint::session
