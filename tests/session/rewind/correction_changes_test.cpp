// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/project.h"
#include "core/session/rewind/correction_changes.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace dewpoint::tests {
namespace {

PositionCorrection ofFrame(std::int64_t frame) {
  PositionCorrection correction;
  correction.frame = frame;
  return correction;
}

TEST(CorrectionChanges, BeginAtTheFirstFrameThatIsOtherwise) {
  using All = std::vector<PositionCorrection>;
  const All two{ofFrame(15), ofFrame(22)};
  EXPECT_FALSE(firstDifferingFrame(two, two));
  EXPECT_EQ(firstDifferingFrame(All{}, two), 15);
  EXPECT_EQ(firstDifferingFrame(two, All{two[1]}), 15);
  EXPECT_EQ(firstDifferingFrame(All{two[0]}, two), 22);
  EXPECT_EQ(appendedCorrections(All{two[0]}, two), All{two[1]});
  EXPECT_EQ(appendedCorrections(two, two), All{});
  EXPECT_FALSE(appendedCorrections(two, All{two[1]}));
}

} // namespace
} // namespace dewpoint::tests
