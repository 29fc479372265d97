// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/rewind/change_rule.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace dewpoint::tests {
namespace {

using Action = ChangeRule::Action;

constexpr double kFast = 0.001;
constexpr double kSlow = 1.0;

/// Results of frames 0 to 99, of which these are old.
OldResults old(std::vector<ResultRange> frames, double secondsPerFrame) {
  return {std::move(frames), 99, secondsPerFrame};
}

TEST(ChangeRule, WhatIsDone) {
  struct Case {
    std::string name;
    ChangeRule::SessionState situation;
    ChangeRule::Decision expected;
  };
  const auto situation = [](bool edited, OldResults results) {
    return ChangeRule::SessionState{.settingsChanged = edited, .oldResults = std::move(results)};
  };
  std::vector<Case> cases{
      {"nothing is old", situation(true, old({}, kFast)), {Action::Nothing, 0}},
      {"quick", situation(true, old({{0, 99}}, kFast)), {Action::TrackAgain, 0}},
      {"slow", situation(true, old({{0, 99}}, kSlow)), {Action::Offer, 0}},
      {"undone: only the end is old",
       situation(true, old({{99, 99}}, kSlow)),
       {Action::TrackAgain, 99}},
      {"what comes after the old ones takes its time too",
       situation(true, old({{0, 0}}, kSlow)),
       {Action::Offer, 0}},
      {"the first of several",
       situation(true, old({{10, 19}, {40, 49}}, kFast)),
       {Action::TrackAgain, 10}},
      {"as long as it takes is unknown",
       situation(true, old({{0, 0}}, 0.0)),
       {Action::TrackAgain, 0}},
      {"changed while it played, then paused",
       situation(false, old({{0, 49}}, kFast)),
       {Action::Offer, 0}},
  };
  cases.push_back({"while it plays", situation(true, old({{0, 49}}, kFast)), {Action::Mark, 0}});
  cases.back().situation.isPlaying = true;
  cases.push_back({"another change during a rerun",
                   situation(true, old({{0, 49}}, kFast)),
                   {Action::TrackAgain, 0}});
  cases.back().situation.isPlaying = cases.back().situation.isRerunning = true;
  cases.push_back({"a rerun goes on", situation(false, old({{0, 49}}, kFast)), {Action::Mark, 0}});
  cases.back().situation.isPlaying = cases.back().situation.isRerunning = true;
  cases.push_back({"live", situation(true, old({{0, 99}}, kFast)), {Action::Nothing, 0}});
  cases.back().situation.isLive = true;
  for (const Case& one : cases) {
    EXPECT_EQ(ChangeRule::decideOn(one.situation), one.expected) << one.name;
  }
}

TEST(ChangeRule, ExpectedTime) {
  EXPECT_DOUBLE_EQ(ChangeRule::expectedSeconds(old({{0, 99}}, 0.01)), 1.0);
  EXPECT_DOUBLE_EQ(ChangeRule::expectedSeconds(old({{40, 49}}, 0.01)), 0.6);
  EXPECT_DOUBLE_EQ(ChangeRule::expectedSeconds(old({}, 0.01)), 0.0);
}

} // namespace
} // namespace dewpoint::tests
