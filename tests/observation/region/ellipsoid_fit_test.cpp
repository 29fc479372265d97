// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/region/ellipsoid_fit.h"
#include "tests/observation/drawn_ellipsoids.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <cmath>

namespace dewpoint::tests {
namespace {

using drawn::kSomethingNew;
using drawn::kVga;
using drawn::RegionScene;

/// A start that is off by `off` meters, as a ball, with next to nothing known.
EllipsoidPrior ellipsoidStart(const Ellipsoid& truth, const Eigen::Vector3d& off,
                              double radius = 0.05) {
  EllipsoidPrior prior;
  prior.ellipsoid = {truth.center + off, ballExtent(radius)};
  prior.information = Eigen::Matrix3d::Identity() / (0.1 * 0.1);
  return prior;
}

Eigen::Vector3d semiAxesOf(const Eigen::Matrix3d& extent) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(extent).eigenvalues().cwiseSqrt();
}

// Three outlines have nine second moments for the six numbers of the extent.
TEST(EllipsoidFit, FindsCenterAndExtentFromThreeCameras) {
  RegionScene scene(drawn::rigAround(3, kVga));
  for (std::uint32_t k = 0; k < 8; ++k) {
    const Ellipsoid truth = drawn::ellipsoid(drawn::placeNear(k, 0.05), {0.1, 0.05, 0.03}, 0.4 * k);
    scene.show({truth});
    const EllipsoidFit fit =
        fitEllipsoid(scene.observation(), ellipsoidStart(truth, 0.03 * drawn::directionOf(k)));
    ASSERT_TRUE(fit.isFound) << k;
    EXPECT_EQ(fit.seeingCameraCount, 3);
    EXPECT_LT((fit.ellipsoid.center - truth.center).norm(), 1e-3) << k;
    EXPECT_NEAR(fit.ellipsoid.radius(), truth.radius(), 0.1 * truth.radius()) << k;
    EXPECT_NEAR(semiAxesOf(fit.ellipsoid.extent).z(), 0.1, 0.006) << k;
  }
}

// Two views leave one number of the extent open, so that a stick may be its mirror image. Seen in
// perspective, its center then lies elsewhere: by up to 12 cm x 12 cm / 2 over a distance of 1 m in
// each image, 10 mm in both.
TEST(EllipsoidFit, FindsTheCenterFromTwoCameras) {
  RegionScene scene(drawn::rigAround(2, kVga));
  for (std::uint32_t k = 0; k < 8; ++k) {
    const Ellipsoid truth =
        drawn::ellipsoid(drawn::placeNear(k, 0.05), {0.12, 0.02, 0.02}, 0.5 * k);
    scene.show({truth});
    const EllipsoidFit fit =
        fitEllipsoid(scene.observation(), ellipsoidStart(truth, 0.03 * drawn::directionOf(k)));
    ASSERT_TRUE(fit.isFound) << k;
    EXPECT_LT((fit.ellipsoid.center - truth.center).norm(), 0.012) << k;
    EXPECT_EQ(fit.degreesOfFreedom, 1);
    EXPECT_LT(fit.disagreement, 0.1) << k; // an ellipsoid has one centroid in all views
  }
}

// What hides a third of it in one camera, and is known to, does not pull: without it the centroid
// of what is left is a sixth of its length off, 20 mm.
TEST(EllipsoidFit, WhatIsHiddenDoesNotPull) {
  RegionScene scene(drawn::rigAround(3, kVga));
  const Ellipsoid truth = drawn::ellipsoid(drawn::kMiddle, {0.06, 0.04, 0.04});
  scene.show({truth});
  EllipsoidPrior prior = ellipsoidStart(truth, {0.002, 0.0, 0.0});
  prior.ellipsoid.extent = truth.extent;
  prior.extentSigma = 0.05;
  const EllipsoidFit whole = fitEllipsoid(scene.observation(), prior);
  const auto outline = EllipsoidProjector(drawn::rigAround(3, kVga)[0]).project(truth);
  ASSERT_TRUE(outline);
  const double half = std::sqrt(outline->extent(0, 0));
  cv::rectangle(scene.image(0),
                cv::Rect(static_cast<int>(outline->center.x() + half / 3.0), 0, 300, 480),
                kSomethingNew, cv::FILLED);
  const EllipsoidFit hidden = fitEllipsoid(scene.observation(), prior);
  ASSERT_TRUE(whole.isFound && hidden.isFound);
  EXPECT_LT((whole.ellipsoid.center - truth.center).norm(), 1e-3);
  EXPECT_LT((hidden.ellipsoid.center - truth.center).norm(), 3e-3);
  EXPECT_GT(hidden.covariance.trace(), 1.5 * whole.covariance.trace());
}

TEST(EllipsoidFit, OneCameraSaysNothingAboutDepth) {
  RegionScene scene(drawn::rigAround(1, kVga));
  const Ellipsoid truth = drawn::ellipsoid(drawn::kMiddle, {0.06, 0.04, 0.04});
  scene.show({truth});
  const EllipsoidFit fit =
      fitEllipsoid(scene.observation(), ellipsoidStart(truth, {0.0, 0.0, 0.0}));
  ASSERT_TRUE(fit.isFound);
  EXPECT_EQ(fit.degreesOfFreedom, 0);
  const Eigen::Vector3d along = drawn::rigAround(1, kVga)[0].opticalAxis();
  EXPECT_GT(std::sqrt(along.dot(fit.covariance * along)), 0.09); // the prior's 0.1
}

TEST(EllipsoidFit, IsNotFoundWhereThereIsNoColor) {
  RegionScene scene(drawn::rigAround(2));
  const Ellipsoid truth = drawn::ellipsoid(drawn::kMiddle, {0.06, 0.04, 0.04});
  const EllipsoidFit fit =
      fitEllipsoid(scene.observation(), ellipsoidStart(truth, {0.0, 0.0, 0.0}));
  EXPECT_FALSE(fit.isFound);
  EXPECT_EQ(fit.views.size(), 2U);
}

} // namespace
} // namespace dewpoint::tests
