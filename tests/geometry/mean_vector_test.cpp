// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/mean_vector.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(MeanVector, IsTheSumByTheNumber) {
  EXPECT_EQ(geometry::meanVector({{1.0, 2.0, 3.0}, {3.0, -2.0, 4.0}}),
            Eigen::Vector3d(2.0, 0.0, 3.5));
  EXPECT_EQ(geometry::meanVector({}), Eigen::Vector3d::Zero());
}

} // namespace
} // namespace dewpoint::tests
