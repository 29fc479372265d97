// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/reversed_frames.h"
#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(ReversedFrames, GoFromTheLastToTheFirstWithRisingTimes) {
  test::FakeRecording recording({.frames = 12, .failsAt = {}, .delivering = {}});
  ReversedFrames reversed(recording, 9);
  EXPECT_EQ(reversed.frameCount(), 10);
  for (std::int64_t k = 0; k < 10; ++k) {
    EXPECT_EQ(reversed.nextFrame(), 9 - k);
    const auto frames = reversed.next();
    ASSERT_TRUE(frames && *frames);
    EXPECT_EQ((*frames)->index, 9 + k);
    EXPECT_NEAR(seconds((*frames)->time), static_cast<double>(9 + k) / 30.0, 1e-8);
    ASSERT_EQ((*frames)->frames.size(), 2U);
    EXPECT_EQ((*frames)->frames[1]->index, 9 + k);
    EXPECT_EQ((*frames)->frames[1]->captureTime, (*frames)->time);
  }
  EXPECT_EQ(reversed.nextFrame(), -1);
  const auto end = reversed.next();
  ASSERT_TRUE(end);
  EXPECT_EQ(*end, nullptr);
}

TEST(ReversedFrames, CanBeSought) {
  test::FakeRecording recording({.frames = 12, .failsAt = {}, .delivering = {}});
  ReversedFrames reversed(recording, 11);
  ASSERT_TRUE(reversed.next());
  ASSERT_TRUE(reversed.seek(8));
  EXPECT_EQ(reversed.nextFrame(), 3);
  EXPECT_EQ((*reversed.next())->index, 19);
  ASSERT_TRUE(reversed.seek(0));
  EXPECT_EQ((*reversed.next())->index, 11);
}

TEST(ReversedFrames, ErrorsAreThoseOfTheSource) {
  test::FakeRecording broken({.frames = 12, .failsAt = 5, .delivering = {}});
  EXPECT_FALSE(ReversedFrames(broken, 6).next());
  test::FakeRecording shorter({.frames = 4, .failsAt = {}, .delivering = {}});
  const auto beyond = ReversedFrames(shorter, 6).next();
  ASSERT_FALSE(beyond);
  EXPECT_EQ(beyond.error().code, ErrorCode::EndedEarly);
}

} // namespace
} // namespace dewpoint::tests
