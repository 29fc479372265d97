// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_source.h"
#include "core/session/session.h"
#include "core/simulation/people/office.h"
#include "core/simulation/people/office_day.h"
#include "core/simulation/room/view_cache.h"

#include <map>
#include <memory>

namespace dewpoint::tests::test {

/// The first frames of the simulated office day, rendered once for all tests of a program. Two
/// people come in within the first 100 frames.
class OfficeRecording : public FrameSetSource {
public:
  explicit OfficeRecording(std::int64_t frames, std::int64_t from = 0)
      : frames_(frames), from_(from) {}
  std::optional<std::int64_t> frameCount() const override { return frames_; }
  double framesPerSecond() const override { return 1e6; } // as fast as possible
  Result<FrameSetPtr> next() override {
    return position_ < frames_ ? at(position_++) : FrameSetPtr();
  }
  Status seek(std::int64_t frame) override {
    position_ = frame;
    return {};
  }

private:
  FrameSetPtr at(std::int64_t frame) const {
    static simulation::ViewCache views;
    static const OfficeRenderer renderer(builtInOfficeScene(), views);
    static std::map<std::int64_t, std::vector<FramePtr>> rendered;
    std::vector<FramePtr>& pictures = rendered[frame + from_];
    for (std::size_t k = pictures.size(); k < renderer.scene().cameras.size(); ++k) {
      auto picture = std::make_shared<Frame>();
      picture->index = frame;
      picture->captureTime =
          timeStamp(static_cast<double>(frame) / renderer.scene().framesPerSecond);
      picture->image = renderer.render(k, frame + from_);
      pictures.push_back(std::move(picture));
    }
    auto set = std::make_shared<FrameSet>();
    set->index = frame;
    set->time = timeStamp(static_cast<double>(frame) / renderer.scene().framesPerSecond);
    set->frames = pictures;
    return set;
  }

  std::int64_t frames_;
  std::int64_t from_;
  std::int64_t position_ = 0;
};

} // namespace dewpoint::tests::test
