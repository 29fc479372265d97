// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/view/cloud_closeup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dewpoint::tests {
namespace {

const Eigen::Vector3d kMean(1.0, -2.0, 0.5);

/// A cloud of three particles with these standard deviations along x, y and z, meters.
TargetSnapshot cloud(const Eigen::Vector3d& sigma) {
  TargetSnapshot target;
  SphereEstimate sphere;
  sphere.mean = kMean;
  sphere.covariance = sigma.cwiseProduct(sigma).asDiagonal();
  sphere.particleCount = 3;
  target.estimate = sphere;
  target.particles.resize(3, 3);
  for (int k = 0; k < 3; ++k) {
    target.particles.row(k) = (kMean + 0.5 * sigma[k] * Eigen::Vector3d::Unit(k)).transpose();
  }
  target.weights.resize(3);
  target.weights << 0.6, 0.1, 0.3;
  return target;
}

TEST(CloudCloseup, ReachesToTheRimOfTheLongestAxis) {
  const auto reach = cloudSemiAxis(cloud({0.001, 0.004, 0.002}));
  ASSERT_TRUE(reach.has_value());
  EXPECT_NEAR(*reach, 0.004 * std::sqrt(7.814727903251), 1e-9);
  TargetSnapshot without = cloud({0.001, 0.004, 0.002});
  without.particles.resize(0, 3);
  EXPECT_FALSE(cloudSemiAxis(without).has_value());
  EXPECT_FALSE(cloudSemiAxis(TargetSnapshot{}).has_value());
}

TEST(CloudCloseup, ShowsXToTheRightAndZUpFromTheFront) {
  const auto closeup = cloudCloseup(cloud({0.001, 0.004, 0.002}), Eigen::Vector3d::UnitX(),
                                    Eigen::Vector3d::UnitZ(), 50.0);
  ASSERT_TRUE(closeup.has_value());
  // Seen from the front, half of the particles are within 0.5 mm: 2.4 * 0.5 mm by 0.45 is 2.7 mm;
  // the next step is 3 mm.
  EXPECT_NEAR(closeup->metersPerPixel, 0.003 / 50.0, 1e-12);
  EXPECT_NEAR(closeup->scaleBarMeters, 0.001, 1e-12);
  ASSERT_EQ(closeup->particles.size(), 3U);
  EXPECT_EQ(closeup->weights.back(), 1.0F); // the likeliest last: the one along x
  EXPECT_NEAR(closeup->particles[2].x(), 0.0005 / 0.00006, 1e-4);
  EXPECT_NEAR(closeup->particles[2].y(), 0.0, 1e-4);
  EXPECT_NEAR(closeup->particles[1].y(), -0.001 / 0.00006, 1e-4); // along z: upwards
  EXPECT_NEAR(closeup->outline.semiMajorAxis, 0.002 * std::sqrt(7.814727903251) / 0.00006, 1e-6);
  EXPECT_NEAR(closeup->outline.semiMinorAxis, 0.001 * std::sqrt(7.814727903251) / 0.00006, 1e-6);
  EXPECT_NEAR(std::abs(std::sin(closeup->outline.angleRadians)), 1.0, 1e-6);
}

TEST(CloudCloseup, ScalesInSteps) {
  const auto scaleOf = [](double sigma) {
    return cloudCloseup(cloud({sigma, sigma, sigma}), Eigen::Vector3d::UnitX(),
                        Eigen::Vector3d::UnitY(), 50.0)
        ->metersPerPixel;
  };
  EXPECT_EQ(scaleOf(0.0009), scaleOf(0.0011)); // 2.4 and 2.9 mm, both within 3 mm
  EXPECT_NEAR(scaleOf(0.0002), 0.0006 / 50.0, 1e-12);
  EXPECT_NEAR(scaleOf(0.0005), 0.0015 / 50.0, 1e-12);
  EXPECT_GT(scaleOf(0.0), 0.0);
}

TEST(CloudCloseup, ShowsTheParticlesRatherThanTheWholeOutline) {
  // Errors of the calibration make the ellipsoid much larger than the cloud.
  TargetSnapshot target = cloud({0.003, 0.003, 0.003});
  target.particles = kMean.transpose().replicate(101, 1).array();
  for (int k = 0; k < 101; ++k) {
    target.particles(k, 0) += k < 95 ? 0.0001 * std::cos(k) : 0.008; // a few search far away
    target.particles(k, 1) += k < 95 ? 0.0001 * std::sin(k) : 0.0;
  }
  target.weights.resize(0);
  const auto closeup =
      cloudCloseup(target, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), 50.0);
  ASSERT_TRUE(closeup.has_value());
  EXPECT_EQ(closeup->particles.size(), 95U);
  EXPECT_GT(closeup->particles[0].norm(), 8.0);    // 0.1 mm
  EXPECT_GT(closeup->outline.semiMajorAxis, 50.0); // beyond the border
  // A cloud that is a point is not enlarged without end.
  target.particles = kMean.transpose().replicate(10, 1).array();
  const auto point = cloudCloseup(target, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), 50.0);
  EXPECT_NEAR(point->metersPerPixel * 50.0, 0.0005, 1e-9); // 8.4 mm by 0.85, a twentieth of it
}

TEST(CloudCloseup, LeavesOutWhatIsFarOrNotFiniteAndThinsOut) {
  TargetSnapshot target = cloud({0.001, 0.001, 0.001});
  target.particles(0, 0) = std::numeric_limits<double>::quiet_NaN();
  target.particles(1, 0) = 3.0;
  const auto few = cloudCloseup(target, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), 50.0);
  EXPECT_EQ(few->particles.size(), 1U);
  target.particles = kMean.transpose().replicate(1000, 1).array();
  target.weights.resize(0);
  const auto many =
      cloudCloseup(target, Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(), 50.0, 100);
  EXPECT_EQ(many->particles.size(), 100U);
  EXPECT_EQ(many->weights.front(), 1.0F);
}

} // namespace
} // namespace dewpoint::tests
