// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/session/drawn_recording.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace dewpoint::tests::test {

/// The drawn recording in light that fades to half.
class FadingRecording final : public FrameSetSource {
public:
  explicit FadingRecording(std::int64_t frames) : frames_(frames) {}

  std::optional<std::int64_t> frameCount() const override { return frames_; }
  double framesPerSecond() const override { return 1e6; }
  Result<FrameSetPtr> next() override {
    if (next_ >= frames_) {
      return FrameSetPtr();
    }
    const auto bright = DrawnRecording::frame(next_);
    auto set = std::make_shared<FrameSet>(*bright);
    for (FramePtr& frame : set->frames) {
      if (frame) {
        auto dark = std::make_shared<Frame>(*frame);
        dark->image = frame->image * (1.0 - 0.5 * double(next_) / double(frames_));
        frame = dark;
      }
    }
    ++next_;
    return set;
  }
  Status seek(std::int64_t frame) override {
    next_ = frame;
    return {};
  }

private:
  std::int64_t frames_;
  std::int64_t next_ = 0;
};

} // namespace dewpoint::tests::test
