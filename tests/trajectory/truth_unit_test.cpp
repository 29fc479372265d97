// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/trajectory/truth_unit.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

/// A target that moves along x for ten frames.
Trajectory moving() {
  Trajectory trajectory;
  for (int frame = 0; frame < 10; ++frame) {
    TrajectorySample sample;
    sample.frame = frame;
    sample.position = {0.1 * frame, 0.4, 0.2};
    trajectory.samples.push_back(sample);
  }
  return trajectory;
}

TEST(TruthUnit, MillimetersAreRecognized) {
  const auto unit = likelyTruthUnitInMeters(moving(), toMeters(moving(), 1000.0));
  ASSERT_TRUE(unit);
  EXPECT_DOUBLE_EQ(*unit, 0.001);
}

TEST(TruthUnit, CentimetersAreRecognized) {
  const auto unit = likelyTruthUnitInMeters(moving(), toMeters(moving(), 100.0));
  ASSERT_TRUE(unit);
  EXPECT_DOUBLE_EQ(*unit, 0.01);
}

TEST(TruthUnit, MetersAreLeftAlone) {
  EXPECT_FALSE(likelyTruthUnitInMeters(moving(), moving()));
  Trajectory elsewhere = moving(); // wrong, but not by a unit
  for (TrajectorySample& sample : elsewhere.samples) {
    sample.position += Eigen::Vector3d(5.0, 0.0, 0.0);
  }
  EXPECT_FALSE(likelyTruthUnitInMeters(elsewhere, moving()));
  EXPECT_FALSE(likelyTruthUnitInMeters({}, moving()));
}

TEST(TruthUnit, ScalesCovariancesWithPositions) {
  Trajectory truth = moving();
  truth.samples[1].covariance.setIdentity();
  truth.samples[1].bestParticle = truth.samples[1].position;
  const Trajectory scaled = toMeters(truth, 0.001);
  EXPECT_DOUBLE_EQ(scaled.samples[1].position.x(), 1e-4);
  EXPECT_DOUBLE_EQ(scaled.samples[1].bestParticle->x(), 1e-4);
  EXPECT_DOUBLE_EQ(scaled.samples[1].covariance(0, 0), 1e-6);
}

} // namespace
} // namespace dewpoint::tests
