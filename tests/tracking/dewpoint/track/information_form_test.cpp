// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track/information_form.h"

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

/// A position known to 10 mm and then, by a measurement of 1 mm that was off by 5 mm along X,
/// better.
class InformationFormTest : public ::testing::Test {
protected:
  static Gaussian3 known() { return {{0.5, 0.4, 0.3}, 1e-4 * Eigen::Matrix3d::Identity()}; }
  static Gaussian3 learned() {
    const double variance = 1.0 / (1.0 / 1e-4 + 1.0 / 1e-6);
    Gaussian3 result{known().mean, variance * Eigen::Matrix3d::Identity()};
    result.mean.x() += variance / 1e-6 * 5e-3;
    return result;
  }
};

TEST_F(InformationFormTest, IsWhatAMeasurementAdds) {
  const InformationForm measurement = InformationForm::measurementBetween(known(), learned(), 0.0);
  EXPECT_NEAR(measurement.information(0, 0), 1e6, 1e6 * 1e-5);
  EXPECT_NEAR(measurement.vector.x(), 5e3, 1e-2);
  const Gaussian3 again = measurement.posterior(known());
  EXPECT_LT((again.mean - learned().mean).norm(), 1e-8);
  EXPECT_LT((again.covariance - learned().covariance).norm(), 1e-11);
  // Off by 5 mm where 1 mm and 10 mm are expected.
  EXPECT_NEAR(measurement.squaredMahalanobisDistance(known().covariance), 25.0 / 101.0, 1e-4);
}

TEST_F(InformationFormTest, MoreNoiseLowersTheInformation) {
  const InformationForm measurement = InformationForm::measurementBetween(known(), learned(), 3e-6);
  EXPECT_NEAR(measurement.information(0, 0), 1.0 / 4e-6, 10.0);
  EXPECT_NEAR(measurement.vector.x(), 5e-3 / 4e-6, 1e-1);
}

TEST_F(InformationFormTest, InflatedItKeepsThePosition) {
  const InformationForm measurement =
      InformationForm::measurementBetween(known(), learned(), 0.0).inflated(4.0);
  EXPECT_NEAR(measurement.information(0, 0), 1e6 / 4.0, 10.0); // 2 mm instead of 1 mm
  EXPECT_NEAR(measurement.vector.x() / measurement.information(0, 0), 5e-3, 1e-7);
}

TEST_F(InformationFormTest, IsTheSameFromElsewhere) {
  const Eigen::Vector3d offset(2e-3, -1e-3, 3e-3);
  const InformationForm measurement =
      InformationForm::measurementBetween(known(), learned(), 0.0).relativeTo(offset);
  Gaussian3 vague{known().mean + offset, Eigen::Matrix3d::Identity()}; // a meter
  const Eigen::Vector3d measured = known().mean + Eigen::Vector3d(5e-3, 0.0, 0.0);
  EXPECT_LT((measurement.posterior(vague).mean - measured).norm(), 1e-6);
}

TEST_F(InformationFormTest, AMeasurementWithoutInformationChangesNothing) {
  const InformationForm measurement = InformationForm::measurementBetween(known(), known(), 1e-8);
  const Gaussian3 after = measurement.posterior(known());
  EXPECT_LT((after.mean - known().mean).norm(), 1e-9);
  EXPECT_LT((after.covariance - known().covariance).norm(), 1e-7);
  EXPECT_LT(measurement.squaredMahalanobisDistance(known().covariance), 1e-6);
}

} // namespace
} // namespace dewpoint::tests
