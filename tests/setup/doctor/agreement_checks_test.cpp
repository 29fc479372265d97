// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/setup/doctor/examined_project.h"

namespace dewpoint::tests {
namespace {

/// Eight seconds of the ball, as the cameras of a rig see it.
class BallSource final : public FrameSetSource {
public:
  explicit BallSource(CameraRig rig) : rig_(std::move(rig)) {}
  std::optional<std::int64_t> frameCount() const override { return 240; }
  double framesPerSecond() const override { return ball::kRate; }
  Result<FrameSetPtr> next() override {
    return next_ < 240 ? std::make_shared<const FrameSet>(ball::framesAt(next_++, rig_))
                       : FrameSetPtr();
  }
  Status seek(std::int64_t frame) override {
    next_ = frame;
    return {};
  }

private:
  CameraRig rig_;
  std::int64_t next_ = 0;
};

class AgreementChecks : public ExaminedProject {
protected:
  /// The images of the recording come from these cameras.
  void seenBy(const CameraRig& rig) {
    options_.open = [rig](const Project&) -> Result<std::unique_ptr<FrameSetSource>> {
      return std::make_unique<BallSource>(rig);
    };
  }
};

TEST_F(AgreementChecks, ImagesThatFitAreFine) {
  seenBy(ball::rigOf(2));
  const auto all = findings();
  EXPECT_EQ(worstLevelOf(all), FindingLevel::Ok) << linesOf(all);
}

TEST_F(AgreementChecks, SwappedImagesAreNamed) {
  CameraRig swapped = ball::rigOf(2);
  std::swap(swapped[0].cameraFromWorld, swapped[1].cameraFromWorld);
  seenBy(swapped);
  const Finding finding = found(FindingKind::CamerasDisagree);
  ASSERT_EQ(finding.placeholderValues.size(), 2U);
  EXPECT_NE(finding.placeholderValues[1].find("swapped"), std::string::npos)
      << finding.placeholderValues[1];
}

TEST_F(AgreementChecks, WhatARunCannotOpenIsAProblem) {
  options_.open = [](const Project&) -> Result<std::unique_ptr<FrameSetSource>> {
    return failure(ErrorCode::FileUnreadable, "left.mp4", "camera 1", "");
  };
  EXPECT_NE(found(FindingKind::CannotOpen).placeholderValues[0].find("left.mp4"),
            std::string::npos);
}

} // namespace
} // namespace dewpoint::tests
