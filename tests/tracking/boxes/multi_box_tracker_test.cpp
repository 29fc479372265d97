// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/observation/boxes/box_histogram.h"
#include "core/tracking/boxes/histogram_tracker.h"
#include "core/tracking/boxes/sugandi_tracker.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/tracker_capabilities.h"
#include "tests/tracking/moving_patch.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>

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

std::unique_ptr<Tracker> startedTracker(const char* method, const std::vector<Target>& targets) {
  auto tracker =
      makeTracker(method, ParameterValues(methodParameters(method)), CameraRig{}, targets);
  EXPECT_TRUE(tracker);
  (*tracker)->restart(5);
  return std::move(*tracker);
}

void go(Tracker& tracker, std::int64_t first, std::int64_t last) {
  ThreadTeam team;
  for (std::int64_t frame = first; frame <= last; ++frame) {
    tracker.beginFrame(frameSet(frame));
    tracker.iterate(team);
  }
}

/// Nothing while the track is absent.
std::optional<BoxEstimate> boxOf(const Tracker& tracker, std::size_t track) {
  const TrackEstimate estimate = tracker.estimate(track);
  const auto* box = std::get_if<BoxEstimate>(&estimate);
  return box != nullptr ? std::optional(*box) : std::nullopt;
}

bool isHeldBy(const Tracker& tracker, std::size_t track) {
  return isConfirmed(tracker.estimate(track));
}

/// What a filter of its own makes of the images of the camera.
template <BoxFilter F> BoxEstimate alone(const char* method) {
  F filter{ParameterValues(methodParameters(method))};
  EXPECT_TRUE(filter.start(MovingPatch{}.image(4), MovingPatch{}.box(4), derivedSeed(5, 1)));
  ThreadTeam team;
  BoxEstimate estimate;
  for (int frame = 5; frame <= 9; ++frame) {
    estimate = filter.step(MovingPatch{}.image(frame), team);
  }
  return estimate;
}

class MultiBoxTrackerTest : public ::testing::TestWithParam<const char*> {};

// Each is what a filter of its own on the images of its camera is, to the bit.
TEST_P(MultiBoxTrackerTest, EachTargetIsFollowedFromTheFrameOfItsBoxOn) {
  auto tracker = startedTracker(GetParam(), {boxed("early", 0), boxed("late", 4)});
  go(*tracker, 0, 3);
  EXPECT_TRUE(boxOf(*tracker, 0));
  EXPECT_FALSE(boxOf(*tracker, 1));
  EXPECT_FALSE(isHeldBy(*tracker, 1));
  EXPECT_TRUE(isAbsent(tracker->estimate(1))); // there is nothing to look for yet
  tracker->beginFrame(frameSet(4));
  EXPECT_EQ(boxOf(*tracker, 1)->box, MovingPatch{}.box(4)); // without any iteration
  EXPECT_TRUE(isHeldBy(*tracker, 1));
  EXPECT_FALSE(isAbsent(tracker->estimate(1)));
  go(*tracker, 4, 4);
  EXPECT_EQ(boxOf(*tracker, 1)->box, MovingPatch{}.box(4));
  go(*tracker, 5, 9);

  const BoxEstimate expected = std::string(GetParam()) == "sugandi"
                                   ? alone<SugandiTracker>(GetParam())
                                   : alone<HistogramTracker>(GetParam());
  const auto belief = boxOf(*tracker, 1);
  ASSERT_TRUE(belief);
  EXPECT_EQ(belief->camera, 1);
  EXPECT_EQ(belief->box, expected.box);
  EXPECT_EQ(belief->similarity, expected.similarity);
  EXPECT_EQ(capability<BoxTracking>(*tracker)->boxParticles(1, 50).centers.rows(), 50);
  EXPECT_EQ(isHeldBy(*tracker, 1), expected.isVisible);
}

// What is drawn in 3D is drawn of estimates with a position.
TEST_P(MultiBoxTrackerTest, TheColorsOfTheGivenBoxAreKept) {
  const auto tracker = startedTracker(GetParam(), {boxed("patch", 2)});
  const auto* const colors = capability<ReferenceColorReporting>(std::as_const(*tracker));
  ASSERT_NE(colors, nullptr);
  go(*tracker, 0, 1);
  EXPECT_TRUE(colors->referenceHistogram(0).empty()); // it has no box yet
  go(*tracker, 2, 6);
  EXPECT_EQ(colors->referenceHistogram(0),
            boxHistogram(MovingPatch{}.image(2), MovingPatch{}.box(2)));
  tracker->restart(5);
  EXPECT_TRUE(colors->referenceHistogram(0).empty());
}

TEST_P(MultiBoxTrackerTest, NothingIsKnownInSpace) {
  auto tracker = startedTracker(GetParam(), {boxed("one", 0)});
  go(*tracker, 0, 3);
  EXPECT_EQ(capability<ParticleCloud>(*tracker), nullptr);
  EXPECT_EQ(capability<RigConfigurable>(*tracker), nullptr);
  EXPECT_FALSE(positionOf(tracker->estimate(0)));
}

TEST_P(MultiBoxTrackerTest, ACopyGoesOnWithTheSameBits) {
  auto tracker = startedTracker(GetParam(), {boxed("one", 0)});
  go(*tracker, 0, 4);
  auto copy = capability<Copyable>(*tracker)->clone();
  copy->beginFrame(nullptr);
  EXPECT_GT(capability<Copyable>(*copy)->memoryBytes(),
            300U * 8U); // 300 particles have one number at least
  go(*tracker, 5, 9);
  go(*copy, 5, 9);
  EXPECT_EQ(boxOf(*copy, 0)->box, boxOf(*tracker, 0)->box);
}

TEST_P(MultiBoxTrackerTest, ABoxOfTheFrameShownStartsAtOnceAndOthersGoOn) {
  auto tracker = startedTracker(GetParam(), {boxed("one", 0)});
  auto undisturbed = startedTracker(GetParam(), {boxed("one", 0)});
  go(*tracker, 0, 5);
  capability<TargetTracking>(*tracker)->setTargets({boxed("zero", 5), boxed("one", 0)});
  EXPECT_EQ(capability<FixedTargetCount>(*tracker), nullptr);
  ASSERT_TRUE(boxOf(*tracker, 0));
  EXPECT_EQ(boxOf(*tracker, 0)->box, MovingPatch{}.box(5));
  go(*tracker, 6, 8);
  go(*undisturbed, 0, 8);
  EXPECT_EQ(boxOf(*tracker, 1)->box, boxOf(*undisturbed, 0)->box);
  capability<TargetTracking>(*tracker)->setTargets(
      {boxed("renamed", 5), boxed("one", 0)}); // by its place
  EXPECT_TRUE(boxOf(*tracker, 0));
  capability<TargetTracking>(*tracker)->setTargets({boxed("renamed", 5), Target{}});
  EXPECT_FALSE(boxOf(*tracker, 1));
}

TEST_P(MultiBoxTrackerTest, ParametersHoldFromTheNextImageOn) {
  auto tracker = startedTracker(GetParam(), {boxed("one", 0)});
  go(*tracker, 0, 3);
  ParameterValues more{methodParameters(GetParam())};
  ASSERT_TRUE(more.set("particles", 700));
  capability<Configurable>(*tracker)->configure(more);
  go(*tracker, 4, 5);
  EXPECT_EQ(boxOf(*tracker, 0)->particleCount, 700);
  EXPECT_TRUE(isHeldBy(*tracker, 0));
}

TEST_P(MultiBoxTrackerTest, ACameraThatDeliversNothingHidesTheTarget) {
  auto tracker = startedTracker(GetParam(), {boxed("one", 0)});
  go(*tracker, 0, 3);
  ThreadTeam team;
  tracker->beginFrame(frameSet(4, false));
  tracker->iterate(team);
  EXPECT_FALSE(isHeldBy(*tracker, 0));
  ASSERT_TRUE(boxOf(*tracker, 0));
  EXPECT_EQ(capability<CameraReporting>(*tracker)->cameraReports(0).at(1).status,
            CameraStatus::NoImage);
  go(*tracker, 5, 5);
  EXPECT_TRUE(isHeldBy(*tracker, 0));
  EXPECT_EQ(capability<CameraReporting>(*tracker)->cameraReports(0).at(1).status,
            CameraStatus::None);
}

TEST_P(MultiBoxTrackerTest, ABoxBesideTheImageIsNotFollowed) {
  Target beside = boxed("beside", 0);
  beside.box->box.x = 5000.0;
  auto tracker = startedTracker(GetParam(), {beside});
  go(*tracker, 0, 2);
  EXPECT_FALSE(boxOf(*tracker, 0));
}

INSTANTIATE_TEST_SUITE_P(Methods, MultiBoxTrackerTest, ::testing::Values("histogram", "sugandi"));

} // namespace
} // namespace dewpoint::tests
