// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/frame_queue.h"
#include "core/capture/live_pairing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <thread>

namespace dewpoint::tests {
namespace {

using namespace std::chrono_literals;

/// A camera of a session that is played in an instant.
struct Player {
  double rate = 30.0;  ///< per second
  double phase = 0.0;  ///< seconds, of the first frame
  double delay = 0.0;  ///< seconds, from what a frame shows to its arrival
  double jitter = 0.0; ///< seconds, of the arrival, to either side
  double from = 0.0;   ///< silent from then ...
  double to = 0.0;     ///< ... to then
};

struct Played {
  std::vector<std::vector<FramePtr>> groups;
  std::int64_t dropped = 0;
  std::int64_t sent = 0;
  TimeStamp longestWait{}; ///< from the arrival of a group's last frame until it was taken
};

FramePtr frameAt(std::int64_t index, TimeStamp time) {
  return std::make_shared<const Frame>(Frame{index, time, {}});
}

/// `each`: how often somebody asks for a group; 0: whenever something may have changed.
Played play(const std::vector<Player>& players, double duration, TimeStamp each = {},
            bool isDelayKnown = true) {
  struct Arrival {
    std::size_t camera;
    FramePtr frame;
  };
  std::multimap<TimeStamp, Arrival> arrivals;
  std::vector<TimeStamp> delays;
  for (std::size_t k = 0; k < players.size(); ++k) {
    const Player& player = players[k];
    const TimeStamp known = isDelayKnown ? timeStamp(player.delay) : TimeStamp{};
    delays.push_back(known);
    for (std::int64_t i = 0; player.phase + i / player.rate < duration; ++i) {
      const double shown = player.phase + static_cast<double>(i) / player.rate;
      if (shown >= player.from && shown < player.to) {
        continue;
      }
      const double wobble = player.jitter * std::sin(12.9898 * static_cast<double>(i * 7 + k));
      const TimeStamp arrival = timeStamp(shown + player.delay + wobble);
      arrivals.emplace(arrival, Arrival{k, frameAt(i, arrival - known)});
    }
  }
  LivePairing pairing(delays);
  for (std::size_t k = 0; k < players.size(); ++k) {
    pairing.setExpectedTiming(k, true, timeStamp(1.0 / players[k].rate));
  }
  Played played;
  played.sent = static_cast<std::int64_t>(arrivals.size());
  std::map<const Frame*, TimeStamp> cameAt;
  TimeStamp asked{};
  const auto take = [&](TimeStamp now) {
    if (now < asked + each) {
      return;
    }
    asked = now;
    while (const auto frames = pairing.takeGroup(now)) {
      TimeStamp last{};
      for (const FramePtr& frame : *frames) {
        last = frame ? std::max(last, cameAt.at(frame.get())) : last;
      }
      if (now < timeStamp(duration)) { // then nothing comes any more
        played.longestWait = std::max(played.longestWait, now - last);
      }
      played.groups.push_back(*frames);
      if (each > TimeStamp{}) {
        break;
      }
    }
  };
  for (TimeStamp now{}; now < timeStamp(duration + 1.0); now += 1ms) {
    while (!arrivals.empty() && arrivals.begin()->first <= now) {
      const auto& [arrival, what] = *arrivals.begin();
      cameAt[what.frame.get()] = arrival;
      pairing.add(what.camera, what.frame);
      arrivals.erase(arrivals.begin());
    }
    take(now);
  }
  played.dropped = pairing.droppedCount();
  return played;
}

std::int64_t framesOf(const Played& played, std::size_t camera) {
  return std::ranges::count_if(played.groups,
                               [&](const auto& group) { return group[camera] != nullptr; });
}

/// Seconds between the frames of full groups, at the most.
double farthestApart(const Played& played) {
  double apart = 0.0;
  for (const auto& group : played.groups) {
    if (group[0] && group[1]) {
      apart = std::max(apart, std::abs(seconds(group[0]->captureTime - group[1]->captureTime)));
    }
  }
  return apart;
}

std::int64_t fullGroups(const Played& played) {
  return std::ranges::count_if(played.groups, [](const auto& group) {
    return std::ranges::all_of(group, [](const auto& frame) { return frame != nullptr; });
  });
}

TEST(LivePairing, EqualCamerasArePaired) {
  for (const double phase : {0.0, 0.004, 0.012, 0.0166, 0.021, 0.03}) {
    const Played played = play({{}, {.phase = phase}}, 4.0);
    EXPECT_GE(fullGroups(played), 118) << phase;
    EXPECT_EQ(played.dropped, 0) << phase;
    EXPECT_LE(farthestApart(played), 0.0251) << phase;
  }
}

TEST(LivePairing, JitterSplitsHardlyAnyPair) {
  for (const double phase : {0.0, 0.012, 0.0166, 0.021}) {
    const Played played = play({{.jitter = 0.003}, {.phase = phase, .jitter = 0.003}}, 10.0);
    EXPECT_GE(fullGroups(played), 292) << phase; // of 300
    EXPECT_EQ(played.dropped, 0) << phase;
  }
}

// The newest of each camera would be 100 ms apart.
TEST(LivePairing, AKnownDelayIsMadeUpFor) {
  const Played played = play({{}, {.delay = 0.1}}, 4.0);
  EXPECT_GE(fullGroups(played), 117);
  EXPECT_LT(farthestApart(played), 0.001);
  EXPECT_EQ(played.dropped, 0);
  // Without knowing of it, what comes together is paired: then it is 100 ms apart in truth.
  const Played blind = play({{}, {.delay = 0.1}}, 4.0, {}, false);
  EXPECT_GE(fullGroups(blind), 114);
}

// A network camera reports when its images were captured; they arrive 150 ms later.
TEST(LivePairing, TheLatencyOfReportedTimesIsWaitedFor) {
  constexpr int kFrames = 60;
  constexpr TimeStamp kInterval = 33ms;
  constexpr TimeStamp kLatency = 150ms;
  LivePairing pairing({TimeStamp{}, TimeStamp{}});
  pairing.setExpectedTiming(0, true, kInterval);
  pairing.setExpectedTiming(1, true, kInterval, kLatency);
  int complete = 0;
  for (TimeStamp now{}; now < kFrames * kInterval; now += 1ms) {
    if (now % kInterval == TimeStamp{}) {
      pairing.add(0, frameAt(now / kInterval, now));
    }
    if (const TimeStamp shown = now - kLatency;
        shown >= TimeStamp{} && shown % kInterval == TimeStamp{}) {
      pairing.add(1, frameAt(shown / kInterval, shown));
    }
    while (const auto frames = pairing.takeGroup(now)) {
      EXPECT_TRUE((*frames)[0] && (*frames)[1]);
      complete += (*frames)[0] && (*frames)[1] ? 1 : 0;
    }
  }
  EXPECT_GE(complete, kFrames - 7);
  EXPECT_EQ(pairing.droppedCount(), 0);
}

TEST(LivePairing, ASlowCameraCostsAFastOneNothing) {
  for (const double slow : {10.0, 15.0, 25.0}) {
    const Played played = play({{}, {.rate = slow, .phase = 0.005}}, 4.0);
    EXPECT_EQ(framesOf(played, 0), 120) << slow;
    EXPECT_EQ(framesOf(played, 1), static_cast<std::int64_t>(4.0 * slow)) << slow;
    EXPECT_EQ(played.dropped, 0) << slow;
    EXPECT_LE(played.longestWait, 30ms) << slow;
  }
}

TEST(LivePairing, GroupsComeInOrderAndFramesOnce) {
  const Played played =
      play({{.rate = 60.0}, {.rate = 25.0, .delay = 0.05, .jitter = 0.004}, {.rate = 15.0}}, 5.0);
  EXPECT_EQ(played.dropped, 0);
  std::int64_t all = 0;
  for (std::size_t camera = 0; camera < 3; ++camera) {
    std::int64_t last = -1;
    for (const auto& group : played.groups) {
      if (group[camera]) {
        EXPECT_GT(group[camera]->index, last);
        last = group[camera]->index;
        ++all;
      }
    }
  }
  EXPECT_EQ(all, played.sent);
}

TEST(LivePairing, ASilentCameraIsWaitedForOnlyAtFirst) {
  const Played played = play({{}, {.from = 1.0, .to = 3.0}}, 4.0);
  EXPECT_EQ(framesOf(played, 0), 120);
  EXPECT_EQ(played.dropped, 0);
  EXPECT_LE(played.longestWait, 42ms);
}

TEST(LivePairing, WhoeverIsSlowGetsTheNewest) {
  const Played played = play({{}, {}}, 4.0, 200ms);
  ASSERT_GE(played.groups.size(), 15U);
  EXPECT_GT(played.dropped, 150);
  EXPECT_LE(played.longestWait, 100ms);
}

TEST(FrameQueue, DropsTheOldestAndCountsThem) {
  FrameQueue queue(3);
  EXPECT_TRUE(queue.takeAll().empty());
  for (int k = 0; k < 5; ++k) {
    queue.put(frameAt(k, {}));
  }
  EXPECT_EQ(queue.droppedCount(), 2);
  const auto taken = queue.takeAll();
  ASSERT_EQ(taken.size(), 3U);
  EXPECT_EQ(taken.front()->index, 2);
  EXPECT_EQ(taken.back()->index, 4);
  EXPECT_TRUE(queue.takeAll().empty());
}

TEST(FrameQueue, NothingIsLostUncountedBetweenThreads) {
  constexpr std::int64_t kFrames = 20000; // enough for the two threads to meet often
  FrameQueue queue(16);
  std::jthread producer([&] {
    for (std::int64_t k = 1; k <= kFrames; ++k) {
      queue.put(frameAt(k, {}));
    }
  });
  std::int64_t taken = 0;
  std::int64_t last = 0;
  while (last < kFrames) {
    for (const FramePtr& frame : queue.takeAll()) {
      ASSERT_GT(frame->index, last);
      last = frame->index;
      ++taken;
    }
  }
  EXPECT_EQ(taken + queue.droppedCount(), kFrames);
}

} // namespace
} // namespace dewpoint::tests
