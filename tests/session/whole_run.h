// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/session/fake_recording.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>

namespace dewpoint::tests::test {

/// Plays from the start to the end once.
inline Trajectory playedToTheEnd(Session& session) {
  session.play();
  EXPECT_TRUE(reaches(session, PlayState::Ended));
  return session.trajectory();
}

/// Begins to track again from this frame.
inline void beginRerun(Session& session, std::int64_t from) {
  std::uint64_t generation = 0;
  std::size_t position = 0;
  session.framesSince(generation, position);
  session.rerunFrom(from);
  ASSERT_TRUE(eventually([&] { return session.framesSince(generation, position).restarted; }));
}

} // namespace dewpoint::tests::test
