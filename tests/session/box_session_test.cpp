// SPDX-License-Identifier: GPL-3.0-or-later
// Methods that follow boxes in a session: one camera, no calibration.
#include "core/base/text_file.h"
#include "core/session/view/camera_overlay.h"
#include "core/tracking/catalog/method_catalog.h"
#include "tests/session/patch_recording.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace dewpoint::tests {
namespace {

using test::boxTarget;
using test::eventually;
using test::patchBox;
using test::patchInputs;
using test::PatchRecording;
using test::reaches;

constexpr double kTolerance = 12.0; // px from the patch's center, which is 30 px wide

/// Steps to this frame.
void stepTo(Session& session, std::int64_t frame) {
  while (session.newest()->history.newestTrackedFrame < frame) {
    const std::int64_t before = session.newest()->history.newestTrackedFrame;
    session.stepFrame();
    ASSERT_TRUE(eventually([&] { return session.newest()->history.newestTrackedFrame > before; }));
  }
}

bool isOnPatch(const BoxSample& sample) {
  const ImageBox truth = MovingPatch{}.box(static_cast<int>(sample.frame));
  return (sample.estimate.box.center() - truth.center()).norm() < kTolerance;
}

std::vector<BoxSample> ofTarget(const BoxTrack& track, int target) {
  std::vector<BoxSample> samples;
  for (const BoxSample& sample : track.samples) {
    if (sample.target == target) {
      samples.push_back(sample);
    }
  }
  return samples;
}

bool sameBoxes(const std::vector<BoxSample>& a, const std::vector<BoxSample>& b) {
  return std::ranges::equal(a, b, [](const BoxSample& one, const BoxSample& other) {
    return one.frame == other.frame && one.estimate.box == other.estimate.box &&
           one.estimate.similarity == other.estimate.similarity;
  });
}

class BoxSessionTest : public ::testing::TestWithParam<const char*> {};

TEST_P(BoxSessionTest, FollowsAndLeavesNothingInSpace) {
  Session session(patchInputs(GetParam(), {boxTarget("patch", patchBox(0))}));
  session.play();
  ASSERT_TRUE(reaches(session, PlayState::Ended));
  const BoxTrack track = session.boxTrack();
  ASSERT_EQ(track.samples.size(), 60U);
  EXPECT_TRUE(isOnPatch(track.samples[29]));
  EXPECT_TRUE(session.trajectory().samples.empty());
  const auto shown = session.newest();
  EXPECT_EQ(shown->family.targetSource, TargetSource::Box);
  EXPECT_TRUE(shown->targets[0].tailPositions.empty());
  EXPECT_TRUE(shown->notices.empty());
  const CameraOverlay overlay = cameraOverlay(*shown, 0, shown->targets[0]);
  EXPECT_FALSE(overlay.estimate);
  ASSERT_TRUE(overlay.box);
  EXPECT_EQ(*overlay.box, track.samples.back().estimate.box);
  EXPECT_EQ(overlay.particles.size(), 300U); // the default number of both
  ASSERT_TRUE(shown->targets[0].histograms);
  EXPECT_EQ(shown->targets[0].histograms->reference.size(), 512U);
  EXPECT_GT(shown->targets[0].histograms->similarity(), 0.5); // it is on the patch
}

TEST_P(BoxSessionTest, ABoxSetWhilePausedStartsAtTheFrameShown) {
  Session session(patchInputs(GetParam(), {}));
  stepTo(session, 10);
  EXPECT_TRUE(session.newest()->targets.empty());
  session.setTargets({boxTarget("patch", patchBox(10))});
  ASSERT_TRUE(eventually([&] {
    const auto shown = session.newest();
    return !shown->targets.empty() && shown->targets[0].box() != nullptr;
  }));
  const auto shown = session.newest();
  EXPECT_EQ(shown->frame, 10);
  EXPECT_TRUE(shown->isTracked);
  EXPECT_EQ(shown->targets[0].status, TargetStatus::Held);
  EXPECT_EQ(shown->targets[0].box()->box, MovingPatch{}.box(10));
  session.play();
  ASSERT_TRUE(reaches(session, PlayState::Ended));
  const auto samples = session.boxTrack().samples;
  ASSERT_EQ(samples.size(), 50U); // frames 10 to 59
  EXPECT_EQ(samples.front().frame, 10);

  // The same as of a project that has the box from the start.
  Session again(patchInputs(GetParam(), {boxTarget("patch", patchBox(10))}));
  again.play();
  ASSERT_TRUE(reaches(again, PlayState::Ended));
  EXPECT_TRUE(sameBoxes(again.boxTrack().samples, samples));
}

TEST_P(BoxSessionTest, ABoxSetInThePastIsTrackedFromThereOn) {
  Session session(patchInputs(GetParam(), {boxTarget("one", patchBox(0))}));
  stepTo(session, 25);
  session.showFrame(8);
  ASSERT_TRUE(eventually([&] { return session.newest()->frame == 8; }));
  session.setTargets({boxTarget("one", patchBox(0)), boxTarget("two", patchBox(8))});
  ASSERT_TRUE(eventually([&] { return ofTarget(session.boxTrack(), 2).size() == 18; })); // 8 to 25
  EXPECT_EQ(ofTarget(session.boxTrack(), 1).size(), 26U);
  ASSERT_TRUE(eventually([&] { return !session.newest()->rerun; }));

  Session again(
      patchInputs(GetParam(), {boxTarget("one", patchBox(0)), boxTarget("two", patchBox(8))}));
  stepTo(again, 25);
  for (const int target : {1, 2}) {
    EXPECT_TRUE(sameBoxes(ofTarget(session.boxTrack(), target), ofTarget(again.boxTrack(), target)))
        << target;
  }
  // Taken away again, as by undo: the other one goes on as it was.
  session.setTargets({boxTarget("one", patchBox(0))});
  ASSERT_TRUE(eventually([&] { return session.newest()->targets.size() == 1; }));
  stepTo(session, 27);
  EXPECT_EQ(ofTarget(session.boxTrack(), 1).size(), 28U);
  // Its box, too: from its frame on nothing is followed.
  session.setTargets({boxTarget("one", std::nullopt)});
  ASSERT_TRUE(eventually([&] { return session.boxTrack().samples.empty(); }));
}

// A moment of the past shows the targets that there are now, in their order, as the timeline and
// the plots do; before its box there is nothing to say of a target.
TEST_P(BoxSessionTest, WhatIsTakenAwayLeavesNothingInThePast) {
  Session session(
      patchInputs(GetParam(), {boxTarget("one", patchBox(4)), boxTarget("two", patchBox(0)),
                               boxTarget("three", patchBox(6))}));
  stepTo(session, 12);
  const auto records = [&session] {
    std::uint64_t generation = 0;
    std::size_t position = 0;
    return session.framesSince(generation, position).records;
  };
  EXPECT_EQ(records()[3].targets[0].status, TargetStatus::Gone);
  EXPECT_EQ(records()[3].targets[1].status, TargetStatus::Held);
  EXPECT_EQ(records()[4].targets[0].status, TargetStatus::Held);
  std::uint64_t generation = 0;
  std::size_t position = 0;
  for (const IterationRecord& record : session.iterationsSince(generation, position).records) {
    EXPECT_FALSE(record.target == 0 && record.frame < 4); // nothing is plotted
    const ImageBox box =
        ImageBox::around(record.position.head<2>(), record.boxWidth, record.boxHeight);
    EXPECT_LT((box.center() - MovingPatch{}.box(static_cast<int>(record.frame)).center()).norm(),
              3.0 * kTolerance); // its position is that of the box
    EXPECT_GT(box.area(), 0.0);
  }
  session.showFrame(8);
  ASSERT_TRUE(eventually([&] { return session.newest()->frame == 8; }));
  session.setTargets({boxTarget("two", patchBox(0))});
  ASSERT_TRUE(eventually([&] { return session.newest()->targets.size() == 1; }));
  const auto shown = session.newest();
  EXPECT_EQ(shown->frame, 8);
  EXPECT_EQ(shown->targets[0].target.name, "two");
  EXPECT_EQ(shown->targets[0].status, TargetStatus::Held);
  EXPECT_NE(shown->targets[0].box(), nullptr);
  ASSERT_EQ(records()[8].targets.size(), 1U);
  EXPECT_EQ(records()[3].targets[0].status, TargetStatus::Held);
  EXPECT_EQ(ofTarget(session.boxTrack(), 1).size(), 13U); // of "two", frames 0 to 12
  EXPECT_EQ(session.boxTrack().samples.size(), 13U);
}

TEST_P(BoxSessionTest, ABoxOfTheFirstFrameIsThereBeforeAnyStep) {
  Session session(patchInputs(GetParam(), {boxTarget("patch", patchBox(0))}));
  const auto hasBox = [&] {
    const auto shown = session.newest();
    return shown->frame == 0 && shown->targets.size() == 1 && shown->targets[0].box() != nullptr &&
           shown->targets[0].status == TargetStatus::Held;
  };
  ASSERT_TRUE(eventually(hasBox)); // opened
  stepTo(session, 5);
  session.restart();
  ASSERT_TRUE(eventually(hasBox));
  EXPECT_FALSE(session.newest()->isTracked);
  stepTo(session, 5);
  session.setMethod("dewpoint", ParameterValues(methodParameters("dewpoint")));
  ASSERT_TRUE(
      eventually([&] { return session.newest()->family.targetSource != TargetSource::Box; }));
  session.setMethod(GetParam(), ParameterValues(methodParameters(GetParam())));
  ASSERT_TRUE(
      eventually([&] { return session.newest()->family.targetSource == TargetSource::Box; }));
  ASSERT_TRUE(eventually(hasBox));
}

TEST_P(BoxSessionTest, TrackedAgainFromAnyMomentTheBitsAreTheSame) {
  Session session(patchInputs(GetParam(), {boxTarget("patch", patchBox(3))}));
  session.play();
  ASSERT_TRUE(reaches(session, PlayState::Ended));
  const auto before = session.boxTrack().samples;
  const BoxEstimate at20 = before.at(17).estimate;
  session.showFrame(20);
  ASSERT_TRUE(eventually([&] { return session.newest()->frame == 20; }));
  ASSERT_NE(session.newest()->targets[0].box(), nullptr);
  EXPECT_EQ(session.newest()->targets[0].box()->box, at20.box);
  EXPECT_EQ(session.newest()->targets[0].boxParticles.centers.rows(), 300);
  std::uint64_t generation = 0;
  std::size_t position = 0;
  session.boxesSince(generation, position);
  session.rerunFrom(20);
  ASSERT_TRUE(eventually([&] { return session.boxesSince(generation, position).restarted; }));
  ASSERT_TRUE(eventually([&] { return session.boxTrack().samples.size() == before.size(); }));
  EXPECT_TRUE(sameBoxes(session.boxTrack().samples, before));
}

TEST_P(BoxSessionTest, APartThatWasNotTrackedYetCanBeClicked) {
  Session session(patchInputs(GetParam(), {}));
  stepTo(session, 2);
  session.showFrame(40);
  ASSERT_TRUE(eventually([&] { return session.newest()->frame == 40; }));
  session.setTargets({boxTarget("patch", patchBox(40))});
  ASSERT_TRUE(eventually([&] { return session.boxTrack().samples.size() == 1; }));
  EXPECT_EQ(session.newest()->frame, 40);
  EXPECT_NE(session.newest()->state, PlayState::Playing);
}

TEST_P(BoxSessionTest, SavesBoxesInPlaceOfATrajectory) {
  Session session(patchInputs(GetParam(), {boxTarget("the patch", patchBox(0))}, 5));
  session.play();
  ASSERT_TRUE(reaches(session, PlayState::Ended));
  const auto folder = std::filesystem::path(testing::TempDir()) / "boxes_saved" / GetParam();
  std::filesystem::remove_all(folder);
  ASSERT_TRUE(session.saveRun(folder));
  EXPECT_FALSE(std::filesystem::exists(folder / "trajectory.csv"));
  const auto csv = readTextFile(folder / "boxes.csv");
  ASSERT_TRUE(csv);
  EXPECT_NE(csv->find("# target 1: the patch, box "), std::string::npos);
  EXPECT_NE(csv->find(std::string("# method: ") + GetParam()), std::string::npos);
  const auto mot = readTextFile(folder / "boxes_mot.txt");
  ASSERT_TRUE(mot);
  EXPECT_EQ(std::ranges::count(*mot, '\n'), 5);
  EXPECT_TRUE(std::filesystem::exists(folder / "run.json"));
}

// Chosen while an earlier moment is looked at: targets begin at their boxes all the same.
TEST_P(BoxSessionTest, AnotherMethodBeginsAtTheBoxes) {
  Session session(patchInputs("barrera", {boxTarget("patch", patchBox(5))}));
  stepTo(session, 20);
  session.showFrame(12);
  ASSERT_TRUE(eventually([&] { return session.newest()->frame == 12; }));
  session.setMethodFrom(12, GetParam(), ParameterValues(methodParameters(GetParam())));
  ASSERT_TRUE(eventually([&] { return session.boxTrack().samples.size() == 16; })); // 5 to 20
}

INSTANTIATE_TEST_SUITE_P(Methods, BoxSessionTest, ::testing::Values("histogram", "sugandi"));

TEST(BoxSession, AHiddenTargetIsHeldAndSaysSo) {
  Session session(patchInputs("histogram", {boxTarget("patch", patchBox(0))}));
  stepTo(session, 31);
  const TargetSnapshot hidden = session.newest()->targets[0];
  ASSERT_NE(hidden.box(), nullptr);
  EXPECT_FALSE(hidden.box()->isVisible);
  EXPECT_EQ(hidden.status, TargetStatus::Searching);
  ASSERT_EQ(hidden.cameraReports.size(), 1U);
  EXPECT_EQ(hidden.cameraReports[0].status, CameraStatus::Hidden);
  stepTo(session, 40);
  EXPECT_EQ(session.newest()->targets[0].status, TargetStatus::Held);
}

} // namespace
} // namespace dewpoint::tests
