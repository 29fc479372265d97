// SPDX-License-Identifier: GPL-3.0-or-later
// A ball that moves before cameras of which one has a fault: it is named within three seconds.
#include "core/base/angle.h"
#include "core/calibration/manual/moved_camera_pose.h"
#include "core/camera_motion/agreement/camera_agreement.h"
#include "tests/camera_motion/agreement/ball_rig.h"

#include <gtest/gtest.h>

#include <optional>

namespace dewpoint::tests {
namespace {

constexpr std::int64_t kInTime = 90; ///< frames: 3 s

using Frames = std::function<FrameSet(std::int64_t)>;

/// What is found of a rig as declared within so many frames.
std::optional<CameraDisagreement> found(const CameraRig& declared, const Frames& frames,
                                        std::int64_t count = kInTime,
                                        const std::vector<Target>& targets = {ball::target()}) {
  CameraAgreement agreement(declared);
  for (std::int64_t k = 0; k < count && agreement.disagreements().empty(); ++k) {
    agreement.watch(frames(k), targets);
  }
  return agreement.disagreements().empty() ? std::nullopt
                                           : std::optional(agreement.disagreements().front());
}

class CameraAgreementOf : public testing::TestWithParam<int> {
protected:
  const CameraRig rig_ = ball::rigOf(GetParam());
  const std::size_t last_ = rig_.size() - 1;
};

TEST_P(CameraAgreementOf, ARightRigIsLeftAlone) {
  const auto frames = [&](std::int64_t k) { return ball::framesAt(k, rig_); };
  EXPECT_FALSE(found(rig_, frames, 240).has_value());
}

TEST_P(CameraAgreementOf, SwappedCamerasAreNamed) {
  const auto frames = [&](std::int64_t k) {
    FrameSet set = ball::framesAt(k, rig_);
    std::swap(set.frames[0], set.frames[last_]);
    return set;
  };
  const auto fault = found(rig_, frames);
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->fault, CameraFault::Swapped);
  EXPECT_EQ(fault->cameras, (std::vector<std::size_t>{0, last_}));
}

TEST_P(CameraAgreementOf, ALateCameraIsNamedWithItsDelay) {
  const auto frames = [&](std::int64_t k) {
    return ball::framesAt(k, rig_, [&](std::size_t camera) { return camera == last_ ? 0.2 : 0.0; });
  };
  const auto fault = found(rig_, frames);
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->fault, CameraFault::Late);
  EXPECT_EQ(fault->cameras, std::vector<std::size_t>{last_});
  EXPECT_NEAR(fault->delay, 0.2, 0.02);
}

// About the image's direction to the first camera: that moves what is seen across the epipolar
// planes of both.
TEST_P(CameraAgreementOf, ARotatedCameraIsNamedWithItsRotation) {
  const double angle = 2.5 * kDegree;
  const Eigen::Vector3d toFirst = rig_[last_].cameraFromWorld * rig_[0].center();
  const Eigen::Vector3d turn = angle * Eigen::Vector3d(toFirst.x(), toFirst.y(), 0.0).normalized();
  CameraRig declared = rig_;
  declared[last_] = rotatedCamera(rig_[last_], turn);
  const auto frames = [&](std::int64_t k) { return ball::framesAt(k, rig_); };
  const auto fault = found(declared, frames);
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->fault, CameraFault::Rotated);
  EXPECT_EQ(fault->cameras.back(), last_);
  ASSERT_EQ(fault->rotationCorrections.size(), fault->cameras.size());
  // What mends it takes the rotation back, as far as the images show it.
  EXPECT_NEAR(-fault->rotationCorrections.back().dot(turn) / angle, angle, 0.5 * kDegree);
}

INSTANTIATE_TEST_SUITE_P(Rigs, CameraAgreementOf, testing::Values(2, 3, 4));

TEST(CameraAgreement, InchesAreTakenFromASizeThatIsKnown) {
  const CameraRig rig = ball::rigOf(2);
  CameraRig declared = rig;
  for (Camera& camera : declared) {
    camera.cameraFromWorld.translation() /= 0.0254; // no farther apart than a large hall is wide
  }
  const auto frames = [&](std::int64_t k) { return ball::framesAt(k, rig); };
  const auto fault = found(declared, frames);
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->fault, CameraFault::Unit);
  EXPECT_DOUBLE_EQ(fault->metersPerUnit, 0.0254);
  Target unknown = ball::target();
  unknown.radius = 0.0;
  EXPECT_FALSE(found(declared, frames, kInTime, {unknown}).has_value());
}

TEST(CameraAgreement, ABallAtRestTellsNothing) {
  const CameraRig rig = ball::rigOf(2);
  const auto frames = [&](std::int64_t k) {
    FrameSet set = ball::framesAt(k, rig);
    const FrameSet first = ball::framesAt(0, rig);
    for (std::size_t camera = 0; camera < rig.size(); ++camera) {
      auto still = std::make_shared<Frame>(*set.frames[camera]);
      still->image = first.frames[1 - camera]->image;
      set.frames[camera] = still;
    }
    return set;
  };
  EXPECT_FALSE(found(rig, frames, 200).has_value());
}

// One camera of three stands somewhere else: neither a rotation nor a delay explains what it sees.
TEST(CameraAgreement, WhatHasNoNameIsSaidAfterAWhile) {
  CameraRig declared = ball::rigOf(3);
  const CameraRig rig = declared;
  declared[1].cameraFromWorld =
      lookAt({0.3, -1.2, 1.0}, {0.1, -0.15, 0.1}, Eigen::Vector3d::UnitX());
  const auto frames = [&](std::int64_t k) { return ball::framesAt(k, rig); };
  const auto fault = found(declared, frames, 240);
  ASSERT_TRUE(fault.has_value());
  EXPECT_EQ(fault->fault, CameraFault::Unknown);
  EXPECT_EQ(fault->cameras, std::vector<std::size_t>{1});
}

TEST(CameraAgreement, WhatIsMendedIsTakenBack) {
  const CameraRig rig = ball::rigOf(3);
  CameraAgreement agreement(rig);
  for (std::int64_t k = 0; k < 300; ++k) {
    FrameSet set = ball::framesAt(k, rig);
    if (k < kInTime) {
      std::swap(set.frames[0], set.frames[1]); // plugged in again as they should be
    }
    agreement.watch(set, {ball::target()});
    EXPECT_TRUE(k != kInTime || !agreement.disagreements().empty());
  }
  EXPECT_TRUE(agreement.disagreements().empty());
}

TEST(CameraAgreement, ImagesOfThePastAndOtherTargetsAreNoFault) {
  const CameraRig rig = ball::rigOf(2);
  CameraAgreement agreement(rig);
  for (std::int64_t k = 0; k < 60; ++k) {
    agreement.watch(ball::framesAt(k, rig), {ball::target()});
  }
  for (std::int64_t k = 0; k < 60; ++k) { // again, and nothing but that
    agreement.watch(ball::framesAt(k, rig), {ball::target()});
  }
  Target green = ball::target();
  green.color = {100.0, 140.0, 0.5, 1.0, 0.1, 0.9};
  for (std::int64_t k = 60; k < 120; ++k) {
    agreement.watch(ball::framesAt(k, rig), {green});
  }
  EXPECT_TRUE(agreement.disagreements().empty());
}

} // namespace
} // namespace dewpoint::tests
