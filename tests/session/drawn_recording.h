// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "tests/session/fake_recording.h"
#include "tests/tracking/drawn_run.h"

#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace dewpoint::tests::test {

/// A red ball on a circle before a wall, with noise; one camera loses it for some frames. A pure
/// function of the frame number.
class DrawnRecording final : public FrameSetSource {
public:
  DrawnRecording(std::int64_t frames, bool live = false) : frames_(frames), live_(live) {}

  static const CameraRig& rig() {
    static const CameraRig rig = drawn::rigAround(2);
    return rig;
  }
  static Eigen::Vector3d ballAt(std::int64_t frame) {
    const double angle = 0.05 * static_cast<double>(frame);
    return drawn::kMiddle + Eigen::Vector3d(0.1 * std::cos(angle), 0.1 * std::sin(angle), 0.0);
  }
  static FrameSetPtr frame(std::int64_t index) {
    const bool lost = index % 40 >= 30 && index % 40 < 33;
    return drawn::framesOf(rig(), {{ballAt(index)}}, index,
                           lost ? std::vector<std::size_t>{1} : std::vector<std::size_t>{});
  }

  std::optional<std::int64_t> frameCount() const override {
    return live_ ? std::nullopt : std::optional(frames_);
  }
  double framesPerSecond() const override { return 1e6; }
  Result<FrameSetPtr> next() override {
    if (live_ && next_ >= frames_) { // nothing comes for the time being
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      auto nothing = std::make_shared<FrameSet>();
      nothing->frames.resize(rig().size());
      return nothing;
    }
    return next_ < frames_ ? frame(next_++) : FrameSetPtr();
  }
  Status seek(std::int64_t frame) override {
    next_ = live_ ? next_ : frame;
    return {};
  }

private:
  std::int64_t frames_;
  bool live_;
  std::int64_t next_ = 0;
};

inline SessionInputs drawnInputs(const std::string& method, std::int64_t frames,
                                 bool live = false) {
  SessionInputs result;
  result.project.name = "drawn";
  result.project.method = method;
  result.project.parameters =
      drawn::parametersOf(method.c_str(), {{"start_x", 0.6}, {"start_y", 0.5}, {"start_z", 0.2}});
  result.project.targets = {drawn::redBall()};
  for (const auto& camera : DrawnRecording::rig()) {
    result.project.cameras.push_back({camera, SourceKind::Simulation, "", 0});
  }
  result.source = std::make_unique<DrawnRecording>(frames, live);
  return result;
}

} // namespace dewpoint::tests::test
