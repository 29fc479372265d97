// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/frames/trouble_search.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

/// Records of the frames 0, 1, 2 …; each list has the states of the targets in one frame.
std::vector<FrameRecord> recordsWith(const std::vector<std::vector<TargetStatus>>& frames) {
  std::vector<FrameRecord> records;
  for (const auto& states : frames) {
    FrameRecord record;
    record.frame = static_cast<std::int64_t>(records.size());
    for (const TargetStatus status : states) {
      record.targets.emplace_back().status = status;
    }
    records.push_back(record);
  }
  return records;
}

TEST(TroubleSearch, FindsWhereATargetStopsBeingTracked) {
  using enum TargetStatus;
  const auto records = recordsWith(
      {{Held}, {Held}, {Searching}, {Lost}, {Held}, {Ambiguous}, {Searching}, {Held}, {Lost}});
  EXPECT_EQ(nextTrouble(records, 0, 1), 2);
  EXPECT_EQ(nextTrouble(records, 2, 1), 5); // lost in 3 is still the trouble that began in 2
  EXPECT_EQ(nextTrouble(records, 5, 1), 8); // searching in 6 is that of 5
  EXPECT_EQ(nextTrouble(records, 8, 1), std::nullopt);
  EXPECT_EQ(nextTrouble(records, 8, -1), 5);
  EXPECT_EQ(nextTrouble(records, 7, -1), 5);
  EXPECT_EQ(nextTrouble(records, 4, -1), 2);
  EXPECT_EQ(nextTrouble(records, 2, -1), std::nullopt);
}

TEST(TroubleSearch, ARunThatBeginsUntrackedBeginsWithTrouble) {
  using enum TargetStatus;
  const auto records = recordsWith({{Searching}, {Searching}, {Held}});
  EXPECT_EQ(nextTrouble(records, 2, -1), 0);
  EXPECT_EQ(nextTrouble(records, 0, 1), std::nullopt);
  EXPECT_EQ(nextTrouble({}, 0, 1), std::nullopt);
  EXPECT_EQ(nextTrouble({}, 0, -1), std::nullopt);
}

TEST(TroubleSearch, ARemovedTargetIsNoTrouble) {
  using enum TargetStatus;
  const auto records = recordsWith({{Held}, {Gone}, {Gone}, {Searching}, {Gone}, {Held}});
  EXPECT_EQ(nextTrouble(records, 0, 1), 3);
  EXPECT_EQ(nextTrouble(records, 3, 1), std::nullopt);
}

TEST(TroubleSearch, LooksAtAllTargetsOrAtOne) {
  using enum TargetStatus;
  const auto records =
      recordsWith({{Held}, {Held, Held}, {Lost, Held}, {Lost, Lost}, {Held, Lost}});
  EXPECT_EQ(nextTrouble(records, 0, 1), 2);
  EXPECT_EQ(nextTrouble(records, 2, 1), 3); // the other target
  EXPECT_EQ(nextTrouble(records, 0, 1, 1), 3);
  EXPECT_EQ(nextTrouble(records, 2, 1, 0), std::nullopt);
  EXPECT_EQ(nextTrouble(records, 0, 1, 7), std::nullopt); // there is no such target
}

TEST(TroubleSearch, FindsWhereAProblemOfACameraBegins) {
  using enum TargetStatus;
  auto records = recordsWith({{Held}, {Held}, {Held}, {Held}, {Held}, {Held}});
  const Error silent{ErrorCode::BadValue, "left", "", "silent"};
  const Error frozen{ErrorCode::BadValue, "right", "", "frozen"};
  const auto one = std::make_shared<const std::vector<Error>>(std::vector{silent});
  const auto same = std::make_shared<const std::vector<Error>>(std::vector{silent});
  const auto two = std::make_shared<const std::vector<Error>>(std::vector{silent, frozen});
  records[1].cameraProblems = one;
  records[2].cameraProblems = same; // another list, the same problem
  records[3].cameraProblems = two;
  records[4].cameraProblems = one; // one of the two has ended
  EXPECT_EQ(nextTrouble(records, 0, 1), 1);
  EXPECT_EQ(nextTrouble(records, 1, 1, 0), 3);
  EXPECT_EQ(nextTrouble(records, 3, 1), std::nullopt);
  EXPECT_EQ(nextTrouble(records, 5, -1), 3);
}

TEST(TroubleSearch, RecordsMayLieApart) {
  using enum TargetStatus;
  auto records = recordsWith({{Held}, {Lost}, {Held}, {Lost}});
  for (FrameRecord& record : records) {
    record.frame *= 8;
  }
  EXPECT_EQ(nextTrouble(records, 3, 1), 8);
  EXPECT_EQ(nextTrouble(records, 10, -1), 8);
  EXPECT_EQ(nextTrouble(records, 20, 1), 24);
}

} // namespace
} // namespace dewpoint::tests
