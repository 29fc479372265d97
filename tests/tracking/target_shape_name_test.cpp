// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/target_shape_name.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(TargetShapeName, IsReadAsItIsWritten) {
  EXPECT_EQ(targetShapeNames(), (std::vector<std::string>{"auto", "ball", "any"}));
  for (const TargetShape shape : {TargetShape::Auto, TargetShape::Ball, TargetShape::Any}) {
    EXPECT_EQ(targetShapeFromName(nameOf(shape)), shape);
  }
  EXPECT_FALSE(targetShapeFromName("Ball"));
  EXPECT_FALSE(targetShapeFromName(""));
}

} // namespace
} // namespace dewpoint::tests
