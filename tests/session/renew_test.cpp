// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/session/drawn_recording.h"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace dewpoint::tests {
namespace {

using test::drawnInputs;
using test::eventually;
using test::reaches;
using test::sameBits;

constexpr std::int64_t kRenewedFrames = 60;

/// A change of the settings, and a session that is told of it.
struct Change {
  const char* name;
  std::function<void(Project&)> make;
  std::function<void(Session&, const Project&)> tell;
};

void setParameter(Project& project, const char* key, double value) {
  ASSERT_TRUE(project.parameters.set(key, value).has_value()) << key;
}

std::vector<Change> changes() {
  const auto tellParameters = [](Session& session, const Project& project) {
    session.setParameters(project.parameters);
  };
  const auto tellTargets = [](Session& session, const Project& project) {
    session.setTargets(project.targets);
  };
  return {
      {"particles", [](Project& project) { setParameter(project, "particles", 333.0); },
       tellParameters},
      {"where it begins", [](Project& project) { setParameter(project, "start_x", 0.7); },
       tellParameters},
      {"radius", [](Project& project) { project.targets[0].radius *= 1.2; }, tellTargets},
      {"one target more",
       [](Project& project) {
         project.targets.push_back(project.targets[0]);
         project.targets.back().name = "another";
         project.targets.back().color.hueMin += 1.0;
       },
       tellTargets},
      {"volume",
       [](Project& project) {
         project.volumeOfInterest = WorldBox{{-1.0, -1.0, -1.0}, {2.0, 2.0, 2.0}};
       },
       [](Session& session, const Project& project) {
         session.setVolumeOfInterest(project.volumeOfInterest);
       }},
  };
}

class RenewTest : public ::testing::TestWithParam<const char*> {};

TEST_P(RenewTest, AChangedRunIsThatOfAFreshOne) {
  for (const Change& change : changes()) {
    Session session(drawnInputs(GetParam(), kRenewedFrames));
    session.play();
    ASSERT_TRUE(reaches(session, PlayState::Ended));
    EXPECT_TRUE(session.oldResults().frameRanges.empty());

    SessionInputs fresh = drawnInputs(GetParam(), kRenewedFrames);
    change.make(fresh.project);
    change.tell(session, fresh.project);
    ASSERT_TRUE(eventually([&] { return !session.oldResults().frameRanges.empty(); }))
        << change.name;
    EXPECT_EQ(session.oldResults().frameRanges,
              (std::vector<ResultRange>{{0, kRenewedFrames - 1}}));
    EXPECT_EQ(session.oldResults().newestFrame, kRenewedFrames - 1);
    EXPECT_GT(session.oldResults().secondsPerFrame, 0.0);

    session.rerunKeepingView(0);
    ASSERT_TRUE(eventually([&] { return session.oldResults().frameRanges.empty(); }))
        << change.name;
    ASSERT_TRUE(reaches(session, PlayState::Ended));
    Session other(std::move(fresh));
    other.play();
    ASSERT_TRUE(reaches(other, PlayState::Ended));
    EXPECT_TRUE(sameBits(session.trajectory(), other.trajectory())) << change.name;
    EXPECT_EQ(session.trajectory().header.entries, other.trajectory().header.entries);
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, RenewTest, ::testing::Values("dewpoint", "barrera"));

TEST(Renew, TheFrameShownStaysShown) {
  Session session(drawnInputs("dewpoint", kRenewedFrames));
  session.play();
  ASSERT_TRUE(reaches(session, PlayState::Ended));
  session.showFrame(20);
  ASSERT_TRUE(eventually([&] { return session.newest()->frame == 20; }));
  Project project = drawnInputs("dewpoint", 1).project;
  setParameter(project, "particles", 333.0);
  session.setParameters(project.parameters);
  ASSERT_TRUE(eventually([&] { return !session.oldResults().frameRanges.empty(); }));
  const TrackSnapshotPtr before = session.newest();
  std::atomic<bool> showedAnother = false;
  session.onSnapshot([&] {
    const TrackSnapshotPtr now = session.newest();
    showedAnother = showedAnother || now->frame != 20 || now->state != PlayState::Paused;
  });
  session.rerunKeepingView(0);
  ASSERT_TRUE(eventually([&] { return session.oldResults().frameRanges.empty(); }));
  session.onSnapshot({});
  EXPECT_FALSE(showedAnother);
  EXPECT_EQ(session.newest()->history.newestTrackedFrame, kRenewedFrames - 1);
  EXPECT_NE(session.newest()->targets[0].particles.rows(), 0);
  EXPECT_NE(before, session.newest());
}

TEST(Renew, WhatWasTrackedBeforeAChangeWhilePlayingIsOld) {
  Session session(drawnInputs("dewpoint", kRenewedFrames));
  const Project before = drawnInputs("dewpoint", 1).project;
  Project after = before;
  setParameter(after, "particles", 333.0);
  for (std::int64_t frame = 0; frame < 10; ++frame) {
    session.stepFrame();
  }
  session.setParameters(after.parameters);
  for (std::int64_t frame = 10; frame < 20; ++frame) {
    session.stepFrame();
  }
  ASSERT_TRUE(eventually([&] { return session.oldResults().newestFrame == 19; }));
  EXPECT_EQ(session.oldResults().frameRanges, (std::vector<ResultRange>{{0, 9}}));
  session.setParameters(before.parameters); // undone
  ASSERT_TRUE(eventually([&] {
    return session.oldResults().frameRanges == std::vector<ResultRange>{{10, 19}};
  }));
  session.rerunKeepingView(10);
  ASSERT_TRUE(eventually([&] { return session.oldResults().frameRanges.empty(); }));

  Session other(drawnInputs("dewpoint", kRenewedFrames));
  for (std::int64_t frame = 0; frame < 20; ++frame) {
    other.stepFrame();
  }
  ASSERT_TRUE(eventually([&] { return other.newest()->history.newestTrackedFrame == 19; }));
  EXPECT_TRUE(sameBits(session.trajectory(), other.trajectory()));
}

TEST(Renew, AFrameUnderWayIsNotOld) {
  Session session(drawnInputs("barrera", kRenewedFrames));
  Project project = drawnInputs("barrera", 1).project;
  session.stepIteration();
  setParameter(project, "particles", 333.0);
  session.setParameters(project.parameters);
  session.stepIteration();
  ASSERT_TRUE(eventually([&] { return session.newest()->iterationCount == 2; }));
  EXPECT_TRUE(session.oldResults().frameRanges.empty());
}

} // namespace
} // namespace dewpoint::tests
