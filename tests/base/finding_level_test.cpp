// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/finding_level.h"

#include <gtest/gtest.h>

#include <vector>

namespace dewpoint::tests {
namespace {

using base::FindingLevel;

struct Found {
  FindingLevel level;
  FindingLevel computed() const { return level; }
};

TEST(FindingLevel, TheWorstOfAllIsSaidByAnyMember) {
  const std::vector<Found> found{{FindingLevel::Ok}, {FindingLevel::Problem}, {FindingLevel::Note}};
  EXPECT_EQ(base::worstLevel(found, &Found::level), FindingLevel::Problem);
  EXPECT_EQ(base::worstLevel(found, &Found::computed), FindingLevel::Problem);
  EXPECT_EQ(base::worstLevel(std::vector<Found>(), &Found::level), FindingLevel::Ok);
}

} // namespace
} // namespace dewpoint::tests
