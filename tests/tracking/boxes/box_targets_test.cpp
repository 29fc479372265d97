// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/tracking/boxes/box_targets.h"
#include "tests/tracking/moving_patch.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

FrameSetPtr frameSet(std::int64_t index, bool delivered = true) {
  auto set = std::make_shared<FrameSet>();
  set->index = index;
  auto frame = std::make_shared<Frame>();
  frame->image = MovingPatch{}.image(static_cast<int>(index));
  set->frames.push_back(nullptr); // a camera that delivers nothing
  set->frames.push_back(delivered ? std::move(frame) : nullptr);
  return set;
}

Target boxed(const char* name, std::int64_t frame) {
  Target target;
  target.name = name;
  target.box = TargetBox{1, frame, MovingPatch{}.box(static_cast<int>(frame))};
  return target;
}

std::unique_ptr<MultiTracker> made(const char* method, const std::vector<Target>& targets) {
  auto tracker =
      makeMultiTracker(method, ParameterValues(methodParameters(method)), CameraRig{}, targets);
  EXPECT_TRUE(tracker);
  (*tracker)->restart(5);
  return std::move(*tracker);
}

void go(MultiTracker& tracker, std::int64_t first, std::int64_t last) {
  ThreadTeam team;
  for (std::int64_t frame = first; frame <= last; ++frame) {
    tracker.beginFrame(frameSet(frame));
    tracker.iterate(team);
  }
}

class BoxTargetsTest : public ::testing::TestWithParam<const char*> {};

// Each is what a BoxTracker of its own on the images of its camera is, to the bit.
TEST_P(BoxTargetsTest, EachTargetIsFollowedFromTheFrameOfItsBoxOn) {
  auto tracker = made(GetParam(), {boxed("early", 0), boxed("late", 4)});
  go(*tracker, 0, 3);
  EXPECT_TRUE(tracker->box(0, 0));
  EXPECT_FALSE(tracker->box(1, 0));
  EXPECT_FALSE(tracker->estimates()[1].valid);
  EXPECT_TRUE(tracker->estimates()[1].gone); // there is nothing to look for yet
  tracker->beginFrame(frameSet(4));
  EXPECT_EQ(tracker->box(1, 0)->estimate.box, MovingPatch{}.box(4)); // without any iteration
  EXPECT_TRUE(tracker->estimates()[1].valid);
  EXPECT_FALSE(tracker->estimates()[1].gone);
  go(*tracker, 4, 4);
  EXPECT_EQ(tracker->box(1, 0)->estimate.box, MovingPatch{}.box(4));
  go(*tracker, 5, 9);

  auto alone = makeBoxTracker(GetParam(), ParameterValues(methodParameters(GetParam())));
  ASSERT_TRUE(alone);
  ASSERT_TRUE((*alone)->start(MovingPatch{}.image(4), MovingPatch{}.box(4), derivedSeed(5, 1)));
  ThreadTeam team;
  BoxEstimate expected;
  for (int frame = 5; frame <= 9; ++frame) {
    expected = (*alone)->step(MovingPatch{}.image(frame), team);
  }
  const auto belief = tracker->box(1, 50);
  EXPECT_EQ(belief->camera, 1);
  EXPECT_EQ(belief->estimate.box, expected.box);
  EXPECT_EQ(belief->estimate.similarity, expected.similarity);
  EXPECT_EQ(belief->centers.rows(), 50);
  EXPECT_EQ(tracker->estimates()[1].valid, expected.visible);
}

// What is drawn in 3D is drawn of estimates with particles.
TEST_P(BoxTargetsTest, NothingIsKnownInSpace) {
  auto tracker = made(GetParam(), {boxed("one", 0)});
  go(*tracker, 0, 3);
  Eigen::ArrayXXd positions;
  Eigen::ArrayXd weights;
  tracker->particles(0, 100, positions, weights);
  EXPECT_EQ(positions.rows(), 0);
  EXPECT_EQ(tracker->estimates()[0].particleCount, 0);
}

TEST_P(BoxTargetsTest, ACopyGoesOnWithTheSameBits) {
  auto tracker = made(GetParam(), {boxed("one", 0)});
  go(*tracker, 0, 4);
  auto copy = tracker->clone();
  copy->beginFrame(nullptr);
  EXPECT_GT(copy->memoryBytes(), 300U * 8U); // 300 particles have one number at least
  go(*tracker, 5, 9);
  go(*copy, 5, 9);
  EXPECT_EQ(copy->box(0, 0)->estimate.box, tracker->box(0, 0)->estimate.box);
}

TEST_P(BoxTargetsTest, ABoxOfTheFrameShownStartsAtOnceAndOthersGoOn) {
  auto tracker = made(GetParam(), {boxed("one", 0)});
  auto undisturbed = made(GetParam(), {boxed("one", 0)});
  go(*tracker, 0, 5);
  tracker->setTargets({boxed("zero", 5), boxed("one", 0)});
  ASSERT_TRUE(tracker->takesAnyNumber());
  ASSERT_TRUE(tracker->box(0, 0));
  EXPECT_EQ(tracker->box(0, 0)->estimate.box, MovingPatch{}.box(5));
  go(*tracker, 6, 8);
  go(*undisturbed, 0, 8);
  EXPECT_EQ(tracker->box(1, 0)->estimate.box, undisturbed->box(0, 0)->estimate.box);
  tracker->setTargets({boxed("renamed", 5), boxed("one", 0)}); // by its place
  EXPECT_TRUE(tracker->box(0, 0));
  tracker->setTargets({boxed("renamed", 5), Target{}});
  EXPECT_FALSE(tracker->box(1, 0));
}

TEST_P(BoxTargetsTest, ParametersHoldFromTheNextImageOn) {
  auto tracker = made(GetParam(), {boxed("one", 0)});
  go(*tracker, 0, 3);
  ParameterValues more{methodParameters(GetParam())};
  ASSERT_TRUE(more.set("particles", 700));
  tracker->configure(more);
  go(*tracker, 4, 5);
  EXPECT_EQ(tracker->box(0, 0)->estimate.particleCount, 700);
  EXPECT_TRUE(tracker->estimates()[0].valid);
}

TEST_P(BoxTargetsTest, ACameraThatDeliversNothingHidesTheTarget) {
  auto tracker = made(GetParam(), {boxed("one", 0)});
  go(*tracker, 0, 3);
  ThreadTeam team;
  tracker->beginFrame(frameSet(4, false));
  tracker->iterate(team);
  EXPECT_FALSE(tracker->estimates()[0].valid);
  ASSERT_TRUE(tracker->box(0, 0));
  EXPECT_EQ(tracker->explain(0).at(1).trouble, CameraStatus::NoImage);
  go(*tracker, 5, 5);
  EXPECT_TRUE(tracker->estimates()[0].valid);
  EXPECT_EQ(tracker->explain(0).at(1).trouble, CameraStatus::None);
}

TEST_P(BoxTargetsTest, ABoxBesideTheImageIsNotFollowed) {
  Target beside = boxed("beside", 0);
  beside.box->box.x = 5000.0;
  auto tracker = made(GetParam(), {beside});
  go(*tracker, 0, 2);
  EXPECT_FALSE(tracker->box(0, 0));
}

INSTANTIATE_TEST_SUITE_P(Methods, BoxTargetsTest, ::testing::Values("histogram", "sugandi"));

} // namespace
} // namespace dewpoint::tests
