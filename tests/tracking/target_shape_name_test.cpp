// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/target_shape_name.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(TargetShapeName, IsReadAsItIsWritten) {
  EXPECT_EQ(targetShapeNames(), (std::vector<std::string>{"auto", "ball", "any"}));
  for (const TargetShape shape : {TargetShape::Auto, TargetShape::Ball, TargetShape::Any}) {
    EXPECT_EQ(targetShapeNamed(nameOf(shape)), shape);
  }
  EXPECT_FALSE(targetShapeNamed("Ball"));
  EXPECT_FALSE(targetShapeNamed(""));
}

} // namespace
} // namespace dewpoint::tests
