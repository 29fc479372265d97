// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/gstreamer/buffer_clock.h"

#include <gtest/gtest.h>

#include <optional>

namespace dewpoint::tests {
namespace {

using namespace std::chrono_literals;
using Clock = BufferClock::Clock;

const Clock::time_point kBegin{1h};

TEST(BufferClock, TakesGoodStamps) {
  BufferClock clock(TimeOrigin::Sender);
  for (int k = 0; k < 5; ++k) {
    const auto stamp = kBegin + k * 33ms;
    const CaptureInstant captured = clock.nextCaptureInstant(stamp, stamp + 40ms);
    EXPECT_EQ(captured.time, stamp);
    EXPECT_EQ(captured.origin, TimeOrigin::Sender);
  }
}

TEST(BufferClock, ReplacesStampsThatCannotBeTrue) {
  for (const auto& [stamp, what] :
       std::vector<std::pair<std::optional<Clock::time_point>, const char*>>{
           {std::nullopt, "none"}, {kBegin + 1s, "of the future"}, {kBegin - 1min, "too old"}}) {
    BufferClock clock(TimeOrigin::Driver);
    const CaptureInstant captured = clock.nextCaptureInstant(stamp, kBegin);
    EXPECT_EQ(captured.time, kBegin) << what;
    EXPECT_EQ(captured.origin, TimeOrigin::Arrival) << what;
  }
}

// As long as good ones came before, a replaced one is as late as they were.
TEST(BufferClock, OneBadStampDoesNotMoveTheOthers) {
  BufferClock clock(TimeOrigin::Driver);
  EXPECT_EQ(clock.nextCaptureInstant(kBegin, kBegin + 50ms).time, kBegin);
  const CaptureInstant replaced = clock.nextCaptureInstant(std::nullopt, kBegin + 84ms);
  EXPECT_EQ(replaced.time, kBegin + 34ms);
  EXPECT_EQ(replaced.origin, TimeOrigin::Arrival);
  const CaptureInstant next = clock.nextCaptureInstant(kBegin + 66ms, kBegin + 116ms);
  EXPECT_EQ(next.time, kBegin + 66ms);
  EXPECT_EQ(next.origin, TimeOrigin::Driver);
}

TEST(BufferClock, TimesIncrease) {
  BufferClock clock(TimeOrigin::Driver);
  const auto first = clock.nextCaptureInstant(kBegin, kBegin);
  const auto repeated = clock.nextCaptureInstant(kBegin, kBegin); // a driver that repeats its stamp
  EXPECT_GT(repeated.time, first.time);
  EXPECT_EQ(repeated.origin, TimeOrigin::Arrival);
  const auto backward = clock.nextCaptureInstant(kBegin - 10ms, kBegin + 5ms);
  EXPECT_GT(backward.time, repeated.time);
  // Slightly in the future, as clocks are rounded: never later than the arrival.
  EXPECT_EQ(clock.nextCaptureInstant(kBegin + 1s + 5ms, kBegin + 1s).time, kBegin + 1s);
}

} // namespace
} // namespace dewpoint::tests
