// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/track_estimate.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(TrackEstimate, TheSpreadIsThatOfAllAxesTogether) {
  SphereEstimate sphere;
  sphere.covariance = Eigen::Vector3d(1.0, 4.0, 4.0).asDiagonal();
  EXPECT_DOUBLE_EQ(spreadOf(sphere.covariance), 3.0);
  EXPECT_DOUBLE_EQ(sphere.spread(), 3.0);
  EXPECT_DOUBLE_EQ(spreadOf(Eigen::Matrix3d::Zero()), 0.0);
}

} // namespace
} // namespace dewpoint::tests
