// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/playback.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace dewpoint::tests {
namespace {

constexpr std::int64_t kHead = 9;  // where the run stands
constexpr std::int64_t kOther = 5; // another frame

const std::array<std::string, 7> kNames{"Paused",    "Playing",   "Ended",  "Viewing",
                                        "Replaying", "Rerunning", "Holding"};

std::string nameOf(const Playback& playback) {
  return kNames.at(playback.state().index());
}

/// A machine in each of the states, in the order of the table.
std::vector<Playback> everyState() {
  std::vector<Playback> all(kNames.size());
  all[1].play();
  all[2].endInput();
  all[3].show(kOther, kHead);
  all[4].show(kOther, kHead);
  all[4].play();
  all[5].rerun({2, kHead}, std::nullopt);
  all[6].rerun({2, kHead}, std::nullopt);
  all[6].hold();
  return all;
}

/// The states that an event leads to, in the order of the table.
std::vector<std::string> after(const std::function<void(Playback&)>& event) {
  std::vector<std::string> names;
  for (Playback& playback : everyState()) {
    event(playback);
    names.push_back(nameOf(playback));
  }
  return names;
}

using Row = std::vector<std::string>;

TEST(Playback, EveryStateCanBeReached) {
  Row names;
  for (const Playback& playback : everyState()) {
    names.push_back(nameOf(playback));
  }
  EXPECT_EQ(names, Row(kNames.begin(), kNames.end()));
}

// The rows of the table in playback.h, one test each.
TEST(PlaybackTable, Play) {
  EXPECT_EQ(
      after([](Playback& playback) { playback.play(); }),
      (Row{"Playing", "Playing", "Ended", "Replaying", "Replaying", "Rerunning", "Rerunning"}));
}

TEST(PlaybackTable, Pause) {
  EXPECT_EQ(after([](Playback& playback) { playback.pause(); }),
            (Row{"Paused", "Paused", "Ended", "Viewing", "Viewing", "Paused", "Paused"}));
}

TEST(PlaybackTable, Hold) {
  EXPECT_EQ(after([](Playback& playback) { playback.hold(); }),
            (Row{"Paused", "Paused", "Ended", "Viewing", "Viewing", "Holding", "Holding"}));
}

TEST(PlaybackTable, ShowAFrame) {
  EXPECT_EQ(after([](Playback& playback) { playback.show(3, kHead); }), Row(7, "Viewing"));
}

TEST(PlaybackTable, ShowTheHead) {
  const Row expected{"Paused", "Paused", "Ended", "Paused", "Paused", "Paused", "Paused"};
  EXPECT_EQ(after([](Playback& playback) { playback.show(kHead, kHead); }), expected);
  EXPECT_EQ(after([](Playback& playback) { playback.show(std::nullopt, kHead); }), expected);
}

TEST(PlaybackTable, ReturnToNewestFrame) {
  EXPECT_EQ(after([](Playback& playback) { playback.returnToNewestFrame(); }),
            (Row{"Paused", "Playing", "Ended", "Paused", "Playing", "Rerunning", "Holding"}));
}

TEST(PlaybackTable, Advance) {
  EXPECT_EQ(after([](Playback& playback) { playback.advance(kOther + 1, kHead); }),
            (Row(kNames.begin(), kNames.end())));
}

TEST(PlaybackTable, AdvanceToTheHead) {
  EXPECT_EQ(after([](Playback& playback) { playback.advance(kHead, kHead); }),
            (Row{"Paused", "Playing", "Ended", "Paused", "Playing", "Rerunning", "Holding"}));
}

TEST(PlaybackTable, AdvanceToNowhere) {
  EXPECT_EQ(after([](Playback& playback) { playback.advance(std::nullopt, kHead); }),
            (Row{"Paused", "Playing", "Ended", "Viewing", "Viewing", "Rerunning", "Holding"}));
}

TEST(PlaybackTable, Restart) {
  EXPECT_EQ(after([](Playback& playback) { playback.restart(); }),
            (Row{"Paused", "Playing", "Paused", "Paused", "Playing", "Playing", "Paused"}));
}

TEST(PlaybackTable, ReachTheGoal) { // of reruns that began while paused
  EXPECT_EQ(after([](Playback& playback) { playback.noteFrameReached(kHead); }),
            (Row{"Paused", "Playing", "Ended", "Viewing", "Replaying", "Paused", "Paused"}));
}

TEST(PlaybackTable, Rerun) {
  EXPECT_EQ(after([](Playback& playback) {
              playback.rerun({1, kHead}, std::nullopt);
            }),
            Row(7, "Rerunning"));
}

TEST(PlaybackTable, TrackOnFrom) {
  EXPECT_EQ(after([](Playback& playback) { playback.continueTrackingAt(20); }), Row(7, "Playing"));
}

TEST(PlaybackTable, EndInput) {
  EXPECT_EQ(after([](Playback& playback) { playback.endInput(); }), Row(7, "Ended"));
}

// The first note of the table: the end of the input is not forgotten while another frame is shown.
TEST(Playback, AnEndedRunIsEndedAgainAfterAnotherFrame) {
  const std::vector<std::function<void(Playback&)>> waysBack{
      [](Playback& playback) { playback.show(kHead, kHead); },
      [](Playback& playback) { playback.returnToNewestFrame(); },
      [](Playback& playback) { playback.advance(kHead, kHead); }};
  for (const auto& goBack : waysBack) {
    for (const bool plays : {false, true}) {
      Playback playback;
      playback.endInput();
      playback.show(kOther, kHead);
      EXPECT_TRUE(playback.hasInputEnded());
      if (plays) {
        playback.play();
      }
      goBack(playback);
      EXPECT_EQ(nameOf(playback), "Ended");
    }
  }
}

// The second note: what follows a rerun, of the states it may begin in.
TEST(Playback, AfterARerunAllIsAsBefore) {
  Row names;
  for (Playback& playback : everyState()) {
    playback.rerun({1, kHead}, std::nullopt);
    EXPECT_FALSE(playback.hasInputEnded());
    EXPECT_FALSE(playback.noteFrameReached(kHead - 1));
    EXPECT_EQ(nameOf(playback), "Rerunning"); // the goal is ahead
    playback.noteFrameReached(kHead);
    names.push_back(nameOf(playback));
  }
  EXPECT_EQ(names, (Row{"Paused", "Playing", "Ended", "Paused", "Paused", "Paused", "Paused"}));
  Playback ended;
  ended.endInput();
  ended.show(kOther, kHead);
  ended.rerun({1, kHead}, std::nullopt);
  ended.noteFrameReached(kHead);
  EXPECT_EQ(nameOf(ended), "Ended");
}

// As when colors change again before the frames were tracked with the first change.
TEST(Playback, ARerunDuringAnotherOneEndsWhereAndAsThatWouldHave) {
  for (const bool waits : {false, true}) {
    Row names;
    for (Playback& playback : everyState()) {
      playback.rerun({4, kHead}, std::nullopt);
      if (waits) {
        playback.hold();
      }
      playback.rerun({1, 6}, std::nullopt); // the head has come to 6
      ASSERT_TRUE(playback.rerunRange());
      EXPECT_EQ(playback.rerunRange()->firstFrame, 1);
      EXPECT_EQ(playback.rerunRange()->lastFrame, kHead);
      EXPECT_EQ(playback.nextFrame(), 1);
      playback.noteFrameReached(6);
      EXPECT_EQ(nameOf(playback), "Rerunning");
      playback.noteFrameReached(kHead);
      names.push_back(nameOf(playback));
    }
    EXPECT_EQ(names, (Row{"Paused", "Playing", "Ended", "Paused", "Paused", "Paused", "Paused"}));
  }
  Playback farther;
  farther.rerun({4, 6}, std::nullopt);
  farther.rerun({1, kHead}, std::nullopt);
  EXPECT_EQ(farther.rerunRange()->lastFrame, kHead);
  Playback looking;
  looking.show(kOther, kHead);
  looking.rerun({4, kHead}, looking.viewedFrame());
  looking.rerun({1, 6}, looking.viewedFrame()); // the head is shown meanwhile
  EXPECT_EQ(looking.noteFrameReached(kHead), kOther);
}

TEST(Playback, ARerunKnowsWhatToShowAfterwards) {
  Playback playback;
  playback.show(kOther, kHead);
  playback.rerun({1, kHead}, playback.viewedFrame());
  EXPECT_FALSE(playback.viewedFrame());
  ASSERT_TRUE(playback.rerunRange());
  EXPECT_EQ(playback.rerunRange()->firstFrame, 1);
  EXPECT_EQ(playback.rerunRange()->lastFrame, kHead);
  EXPECT_EQ(playback.noteFrameReached(kHead), kOther);
  EXPECT_FALSE(playback.rerunRange());
  playback.rerun({1, kHead}, std::nullopt);
  playback.hold();
  EXPECT_TRUE(playback.rerunRange()); // it waits
  playback.pause();
  EXPECT_FALSE(playback.rerunRange());
}

TEST(Playback, SnapshotsSayThreeStates) {
  std::vector<PlayState> states;
  for (const Playback& playback : everyState()) {
    states.push_back(playback.playState());
    EXPECT_EQ(playback.isRunning(), playback.playState() == PlayState::Playing);
  }
  using enum PlayState;
  EXPECT_EQ(states,
            (std::vector<PlayState>{Paused, Playing, Ended, Paused, Playing, Playing, Paused}));
}

TEST(Playback, TheFrameShownMovesOn) {
  for (const bool plays : {false, true}) {
    Playback playback;
    playback.show(kOther, kHead);
    if (plays) {
      playback.play();
    }
    playback.advance(kOther + 1, kHead);
    EXPECT_EQ(playback.viewedFrame(), kOther + 1);
    playback.advance(std::nullopt, kHead); // a part that was not tracked yet has an end too
    EXPECT_EQ(playback.viewedFrame(), kOther + 1);
  }
}

TEST(Playback, WhatBecomesOfAFrame) {
  Playback playback;
  EXPECT_EQ(playback.headProgress(), Playback::HeadProgress::None);
  EXPECT_EQ(playback.nextFrame(), 0);
  playback.forgetEstimates(); // there is no frame that could be tracked anew
  EXPECT_EQ(playback.headProgress(), Playback::HeadProgress::None);
  playback.setHead(7);
  EXPECT_EQ(playback.headProgress(), Playback::HeadProgress::Taken);
  EXPECT_EQ(playback.nextFrame(), 8);
  playback.noteIteration();
  EXPECT_EQ(playback.headProgress(), Playback::HeadProgress::Tracked);
  playback.noteRecorded();
  EXPECT_EQ(playback.headProgress(), Playback::HeadProgress::Recorded);
  playback.noteIteration(); // another iteration: its record is replaced
  EXPECT_EQ(playback.headProgress(), Playback::HeadProgress::Recorded);
  playback.forgetEstimates();
  EXPECT_EQ(playback.headProgress(), Playback::HeadProgress::Taken);
  playback.rerun({3, 7}, std::nullopt);
  EXPECT_EQ(playback.headProgress(), Playback::HeadProgress::None);
  EXPECT_EQ(playback.nextFrame(), 3);
  playback.continueTrackingAt(30);
  EXPECT_EQ(playback.nextFrame(), 30);
  playback.setHead(30);
  playback.restart();
  EXPECT_EQ(playback.headProgress(), Playback::HeadProgress::None);
  EXPECT_EQ(playback.nextFrame(), 0);
}

TEST(Playback, WhatASnapshotLacks) {
  Playback playback;
  EXPECT_EQ(playback.missingContent(), Playback::MissingContent::Nothing);
  playback.notePublished(true, true); // first the images, then what belongs to them
  EXPECT_EQ(playback.missingContent(), Playback::MissingContent::Images);
  playback.notePublished(false, true);
  EXPECT_EQ(playback.missingContent(), Playback::MissingContent::Maps);
  playback.noteMissingContentPublished();
  EXPECT_EQ(playback.missingContent(), Playback::MissingContent::Nothing);
  playback.notePublished(false, false);
  EXPECT_EQ(playback.missingContent(), Playback::MissingContent::Nothing);
}

} // namespace
} // namespace dewpoint::tests
