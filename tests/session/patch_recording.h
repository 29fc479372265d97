// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "core/tracking/catalog/method_catalog.h"
#include "tests/session/fake_recording.h"
#include "tests/tracking/moving_patch.h"

#include <memory>
#include <optional>
#include <utility>

namespace dewpoint::tests::test {

/// One camera without a calibration that shows a moving patch, hidden in some frames.
class PatchRecording final : public FrameSetSource {
public:
  explicit PatchRecording(std::int64_t frames) : frames_(frames) {}

  static bool isHidden(std::int64_t frame) { return frame >= 30 && frame < 34; }
  static FrameSetPtr frameSet(std::int64_t index) {
    auto frame = std::make_shared<Frame>();
    frame->image = MovingPatch{}.image(static_cast<int>(index), !isHidden(index));
    frame->index = index;
    frame->captureTime = TimeStamp(std::chrono::milliseconds(40 * index));
    auto set = std::make_shared<FrameSet>();
    set->index = index;
    set->time = frame->captureTime;
    set->frames = {std::move(frame)};
    return set;
  }

  std::optional<std::int64_t> frameCount() const override { return frames_; }
  double framesPerSecond() const override { return 1e6; }
  Result<FrameSetPtr> next() override {
    return next_ < frames_ ? frameSet(next_++) : FrameSetPtr();
  }
  Status seek(std::int64_t frame) override {
    next_ = frame;
    return {};
  }

private:
  std::int64_t frames_;
  std::int64_t next_ = 0;
};

/// The box that shows the patch of a frame.
inline TargetBox patchBox(std::int64_t frame) {
  return {0, frame, MovingPatch{}.box(static_cast<int>(frame))};
}

inline Target boxTarget(const char* name, std::optional<TargetBox> box) {
  Target target;
  target.name = name;
  target.box = box;
  return target;
}

inline SessionInputs patchInputs(const char* method, std::vector<Target> targets,
                                 std::int64_t frames = 60) {
  SessionInputs result;
  result.project.name = "patch";
  result.project.method = method;
  result.project.parameters = ParameterValues(methodParameters(method));
  result.project.targets = std::move(targets);
  ProjectCamera camera;
  camera.camera.name = "camera 1";
  camera.camera.intrinsics = {320, 240, 320.0, 320.0, 159.5, 119.5};
  camera.camera.cameraFromWorld = lookAt({2.0, 0.0, 1.2}, {0.0, 0.0, 0.25});
  result.project.cameras = {camera};
  result.source = std::make_unique<PatchRecording>(frames);
  return result;
}

} // namespace dewpoint::tests::test
