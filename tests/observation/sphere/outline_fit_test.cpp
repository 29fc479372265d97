// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/sphere/outline_fit.h"
#include "tests/observation/fit_scene.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::tests {
namespace {

using drawn::Ball;
using drawn::FitScene;
using drawn::kRadius;
using drawn::kVga;

/// A start that is off by `radii`, with next to nothing known of the place (a meter).
OutlinePrior outlineStart(const Eigen::Vector3d& center, std::uint32_t index, double radii) {
  OutlinePrior prior;
  prior.center = center + radii * kRadius * drawn::directionOf(index);
  prior.radius = kRadius;
  prior.information = Eigen::Matrix3d::Identity();
  return prior;
}

/// Errors over some places and starts, meters.
struct Errors {
  double largest = 0.0;
  double rootMeanSquare = 0.0;
  double bias = 0.0; ///< length of the mean error
};

Errors errorsOf(int cameras, double startRadii, double reach) {
  FitScene scene(drawn::rigAround(cameras, kVga));
  Errors errors;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  constexpr std::uint32_t kPlaces = 30;
  for (std::uint32_t k = 0; k < kPlaces; ++k) {
    const Eigen::Vector3d truth = drawn::placeNear(k, reach);
    scene.show({Ball{truth, kRadius}});
    const OutlineFit fit = fitOutline(scene.views(), outlineStart(truth, k, startRadii));
    EXPECT_TRUE(fit.isFound) << k;
    EXPECT_NEAR(fit.radius, kRadius, 1e-6 * kRadius) << k; // known, so it stays
    EXPECT_EQ(fit.edgeCounts.size(), static_cast<std::size_t>(cameras));
    const Eigen::Vector3d error = fit.center - truth;
    errors.largest = std::max(errors.largest, error.norm());
    errors.rootMeanSquare += error.squaredNorm() / kPlaces;
    sum += error;
  }
  errors.rootMeanSquare = std::sqrt(errors.rootMeanSquare);
  errors.bias = sum.norm() / kPlaces;
  return errors;
}

// A pixel is 1.7 mm wide there (1 m / 600). Its raster alone moves an edge by 0.29 pixels
// (uniform), thirty of them the middle by 0.29 / sqrt(15) = 0.075 pixels along each axis of each
// image: 0.13 mm, so about 0.2 mm in space; single places may be three times as far off.
TEST(OutlineFit, TwoCamerasWithinAThirdOfAMillimeter) {
  for (const double startRadii : {0.0, 0.25, 0.5}) {
    const Errors errors = errorsOf(2, startRadii, 0.2);
    EXPECT_LT(errors.rootMeanSquare, 0.33e-3) << startRadii;
    EXPECT_LT(errors.bias, 0.15e-3) << startRadii;
    EXPECT_LT(errors.largest, 0.9e-3) << startRadii;
  }
}

TEST(OutlineFit, ThreeCamerasWithinAThirdOfAMillimeter) {
  const Errors errors = errorsOf(3, 0.5, 0.2);
  EXPECT_LT(errors.rootMeanSquare, 0.33e-3);
  EXPECT_LT(errors.largest, 0.6e-3);
}

// One camera: the direction is as good as with two, the depth only as good as the size, of which
// the common offset of the edges leaves about a pixel in twenty: 5 % of a meter.
TEST(OutlineFit, OneCameraKnowsTheDirectionAndLittleOfTheDepth) {
  FitScene scene(drawn::rigAround(1, kVga));
  for (std::uint32_t k = 0; k < 30; ++k) {
    const Eigen::Vector3d truth = drawn::placeNear(k, 0.2);
    scene.show({Ball{truth, kRadius}});
    const OutlineFit fit = fitOutline(scene.views(), outlineStart(truth, k, 0.5));
    ASSERT_TRUE(fit.isFound);
    const Eigen::Vector3d from = drawn::rigAround(1, kVga)[0].center();
    const Eigen::Vector3d along = (truth - from).normalized();
    const Eigen::Vector3d error = fit.center - truth;
    EXPECT_LT((error - error.dot(along) * along).norm(), 0.7e-3) << k;
    EXPECT_LT(std::abs(error.dot(along)), 0.05) << k;
  }
}

TEST(OutlineFit, CovarianceIsPositiveDefiniteAndLargerAlongTheAxisOfOneCamera) {
  for (const int cameras : {1, 2, 3}) {
    FitScene scene(drawn::rigAround(cameras, kVga));
    const Eigen::Vector3d truth = drawn::placeNear(3, 0.1);
    scene.show({Ball{truth, kRadius}});
    const OutlineFit fit = fitOutline(scene.views(), outlineStart(truth, 3, 0.2));
    ASSERT_TRUE(fit.isFound);
    EXPECT_LT((fit.covariance - fit.covariance.transpose()).cwiseAbs().maxCoeff(), 1e-15);
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(fit.covariance);
    EXPECT_GT(eigen.eigenvalues()[0], 0.0);
    EXPECT_LT(eigen.eigenvalues()[0], 1e-6); // a millimeter
    if (cameras == 1) {
      const Eigen::Vector3d along = (truth - drawn::rigAround(1, kVga)[0].center()).normalized();
      EXPECT_GT(std::abs(eigen.eigenvectors().col(2).dot(along)), 0.99);
      EXPECT_GT(eigen.eigenvalues()[2], 25.0 * eigen.eigenvalues()[1]);
    } else {
      EXPECT_LT(eigen.eigenvalues()[2], 1e-6);
    }
  }
}

/// Covers the part of the image on one side of the ball's middle.
void cut(FitScene& scene, std::size_t camera, const Eigen::Vector3d& truth, bool newThing) {
  const auto outline = scene.projector(camera).project(truth, kRadius);
  ASSERT_TRUE(outline);
  cv::Mat& image = scene.image(camera);
  const cv::Rect left(0, 0, static_cast<int>(outline->center.x()), image.rows);
  image(left) = newThing ? cv::Scalar(200, 60, 30) : cv::Scalar::all(drawn::kWall);
}

// Half of one disc is gone, by something new or by something that looks like the wall. The other
// camera and the other half still fix the place to a millimeter.
TEST(OutlineFit, HalfOfTheDiscCutOffInOneCamera) {
  for (const bool newThing : {true, false}) {
    FitScene scene(drawn::rigAround(2, kVga));
    for (std::uint32_t k = 0; k < 20; ++k) {
      const Eigen::Vector3d truth = drawn::placeNear(k, 0.15);
      scene.show({Ball{truth, kRadius}});
      cut(scene, 0, truth, newThing);
      const OutlineFit fit = fitOutline(scene.views(), outlineStart(truth, k, 0.2));
      ASSERT_TRUE(fit.isFound);
      EXPECT_LT((fit.center - truth).norm(), 1.5e-3) << k << (newThing ? " new" : " wall");
    }
  }
}

TEST(OutlineFit, AHiddenHalfMakesTheCovarianceLarger) {
  FitScene scene(drawn::rigAround(2, kVga));
  const Eigen::Vector3d truth = drawn::placeNear(1, 0.1);
  scene.show({Ball{truth, kRadius}});
  const OutlineFit whole = fitOutline(scene.views(), outlineStart(truth, 1, 0.1));
  cut(scene, 0, truth, true);
  const OutlineFit half = fitOutline(scene.views(), outlineStart(truth, 1, 0.1));
  ASSERT_TRUE(whole.isFound && half.isFound);
  EXPECT_GT(half.covariance.trace(), whole.covariance.trace());
  EXPECT_LT(half.edgeCounts[0], whole.edgeCounts[0]);
}

/// A place beside the ball, seen from camera 0: across its line of sight.
Eigen::Vector3d besideIn(const CameraRig& rig, const Eigen::Vector3d& truth, double radii) {
  const Eigen::Vector3d along = (truth - rig[0].center()).normalized();
  return truth + radii * kRadius * along.cross(Eigen::Vector3d::UnitZ()).normalized() +
         3.0 * kRadius * along;
}

// A twin behind it that touches or overlaps its outline in one camera only.
TEST(OutlineFit, ATwinThatTouchesInOneCamera) {
  const CameraRig rig = drawn::rigAround(2, kVga);
  FitScene scene(rig);
  for (const double radii : {2.0, 1.6, 1.2}) {
    for (std::uint32_t k = 0; k < 10; ++k) {
      const Eigen::Vector3d truth = drawn::placeNear(k, 0.1);
      scene.show({Ball{truth, kRadius}, Ball{besideIn(rig, truth, radii), kRadius}});
      const OutlineFit fit = fitOutline(scene.views(), outlineStart(truth, k, 0.15));
      ASSERT_TRUE(fit.isFound);
      EXPECT_LT((fit.center - truth).norm(), 1.5e-3) << k << " at " << radii;
    }
  }
}

// Within 3 % from a guess that is 15 % off, its standard deviation said to be 20 %.
TEST(OutlineFit, UnknownRadiusIsFoundWithTwoCameras) {
  FitScene scene(drawn::rigAround(2, kVga));
  for (std::uint32_t k = 0; k < 20; ++k) {
    const Eigen::Vector3d truth = drawn::placeNear(k, 0.15);
    for (const double guess : {0.85, 1.0, 1.15}) {
      scene.show({Ball{truth, kRadius}});
      OutlinePrior prior = outlineStart(truth, k, 0.2);
      prior.radius = guess * kRadius;
      prior.logRadiusVariance = 0.04;
      const OutlineFit fit = fitOutline(scene.views(), prior);
      ASSERT_TRUE(fit.isFound);
      EXPECT_NEAR(fit.radius, kRadius, 0.03 * kRadius) << k << " from " << guess;
      EXPECT_LT((fit.center - truth).norm(), 1e-3) << k << " from " << guess;
      EXPECT_GT(fit.logRadiusVariance, 0.0);
      EXPECT_LT(fit.logRadiusVariance, 0.04);
    }
  }
}

TEST(OutlineFit, NoiseOfACameraKeepsItBelowAMillimeter) {
  FitScene scene(drawn::rigAround(2, kVga));
  for (std::uint32_t k = 0; k < 10; ++k) {
    const Eigen::Vector3d truth = drawn::placeNear(k, 0.2);
    scene.show({Ball{truth, kRadius}}, 6.0, k);
    const OutlineFit fit = fitOutline(scene.views(), outlineStart(truth, k, 0.5));
    ASSERT_TRUE(fit.isFound);
    EXPECT_LT((fit.center - truth).norm(), 1e-3) << k;
  }
}

TEST(OutlineFit, FindsNothingInAnEmptyImage) {
  FitScene scene(drawn::rigAround(2, kVga));
  const OutlineFit fit = fitOutline(scene.views(), outlineStart(drawn::kMiddle, 0, 0.0));
  EXPECT_FALSE(fit.isFound);
  EXPECT_EQ(fit.edgeCounts, (std::vector<int>{0, 0}));
}

TEST(OutlineFit, FindsNothingWhereNoCameraLooksOrNoneHasAnImage) {
  FitScene scene(drawn::rigAround(2, kVga));
  scene.show({Ball{drawn::kMiddle, kRadius}});
  EXPECT_FALSE(fitOutline({}, outlineStart(drawn::kMiddle, 0, 0.0)).isFound);
  auto views = scene.views();
  EXPECT_FALSE(fitOutline(views, outlineStart({5.0, 5.0, 50.0}, 0, 0.0)).isFound);
  scene.labels(0).clear();
  scene.labels(1).clear();
  EXPECT_FALSE(fitOutline(views, outlineStart(drawn::kMiddle, 0, 0.0)).isFound);
}

TEST(OutlineFit, ACameraWithoutAnImageIsLeftOut) {
  FitScene scene(drawn::rigAround(3, kVga));
  const Eigen::Vector3d truth = drawn::placeNear(2, 0.1);
  scene.show({Ball{truth, kRadius}});
  auto views = scene.views();
  scene.labels(1).clear();
  const OutlineFit fit = fitOutline(views, outlineStart(truth, 2, 0.3));
  ASSERT_TRUE(fit.isFound);
  EXPECT_EQ(fit.edgeCounts[1], 0);
  EXPECT_GT(fit.edgeCounts[0], 0);
  EXPECT_GT(fit.edgeCounts[2], 0);
  EXPECT_LT((fit.center - truth).norm(), 0.9e-3);
}

// The second camera looked when the ball was 2 cm farther along; told so, the fit agrees.
TEST(OutlineFit, OffsetsMoveTheBallToWhenACameraLooked) {
  const CameraRig rig = drawn::rigAround(2, kVga);
  const Eigen::Vector3d offset(0.015, -0.01, 0.008);
  const Eigen::Vector3d truth = drawn::placeNear(4, 0.1);
  FitScene scene(rig);
  scene.show({Ball{truth, kRadius}});
  scene.image(1) = drawn::draw(rig[1], {Ball{truth + offset, kRadius}});
  auto views = scene.views();
  views[1].offset = offset;
  const OutlineFit fit = fitOutline(views, outlineStart(truth, 4, 0.3));
  ASSERT_TRUE(fit.isFound);
  EXPECT_LT((fit.center - truth).norm(), 0.9e-3);
}

// With a prior of a tenth of a millimeter the images, ten times less sure, hardly move it.
TEST(OutlineFit, ASurePriorIsKept) {
  FitScene scene(drawn::rigAround(1, kVga));
  const Eigen::Vector3d truth = drawn::placeNear(6, 0.1);
  scene.show({Ball{truth, kRadius}});
  OutlinePrior prior = outlineStart(truth, 6, 0.1);
  prior.information = 1e12 * Eigen::Matrix3d::Identity();
  const OutlineFit fit = fitOutline(scene.views(), prior);
  ASSERT_TRUE(fit.isFound);
  EXPECT_LT((fit.center - prior.center).norm(), 1e-4);
}

// Three cameras agree as well as their edges do; one that was turned, so that its image lies six
// pixels aside, does not. One camera alone cannot disagree.
// A ball that is smaller than said by a seventh is 2.9 of 20 pixels smaller in each of two cameras:
// with 0.7 px of uncertainty, 17 squared deviations each, if no edge were taken for another's.
TEST(OutlineFit, TellsWhetherTheSizeIsRight) {
  FitScene scene(drawn::rigAround(2));
  for (std::uint32_t k = 0; k < 10; ++k) {
    const Eigen::Vector3d truth = drawn::placeNear(k, 0.2);
    OutlinePrior prior;
    prior.center = truth + Eigen::Vector3d(0.005, -0.005, 0.0);
    prior.radius = 0.035;
    scene.show({Ball{truth, 0.035}});
    const OutlineFit right = fitOutline(scene.views(), prior);
    scene.show({Ball{truth, 0.030}});
    const OutlineFit wrong = fitOutline(scene.views(), prior);
    ASSERT_TRUE(right.isFound && wrong.isFound) << k;
    EXPECT_LT(right.sizeDeviation, 2.0) << k;
    EXPECT_GT(wrong.sizeDeviation, 8.0) << k;
  }
}

TEST(OutlineFit, TellsHowMuchTheCamerasDisagree) {
  FitScene scene(drawn::rigAround(3, kVga));
  double agreeing = 0.0;
  constexpr std::uint32_t kPlaces = 10;
  for (std::uint32_t k = 0; k < kPlaces; ++k) {
    const Eigen::Vector3d truth = drawn::placeNear(k, 0.1);
    scene.show({Ball{truth, kRadius}}, 3.0, k);
    const OutlineFit fit = fitOutline(scene.views(), outlineStart(truth, k, 0.1));
    ASSERT_EQ(fit.degreesOfFreedom,
              3); // two coordinates in each of three images, against three in space
    agreeing += fit.disagreement / fit.degreesOfFreedom / kPlaces;
    const cv::Mat before = scene.image(2).clone();
    before(cv::Rect(6, 0, before.cols - 6, before.rows))
        .copyTo(scene.image(2)(cv::Rect(0, 0, before.cols - 6, before.rows)));
    const OutlineFit turned = fitOutline(scene.views(), outlineStart(truth, k, 0.1));
    EXPECT_GT(turned.disagreement / turned.degreesOfFreedom, 20.0) << k;
  }
  EXPECT_LT(agreeing, 1.5);
  EXPECT_GT(agreeing, 0.05);
  FitScene alone(drawn::rigAround(1, kVga));
  alone.show({Ball{drawn::kMiddle, kRadius}});
  const OutlineFit fit = fitOutline(alone.views(), outlineStart(drawn::kMiddle, 0, 0.1));
  EXPECT_EQ(fit.degreesOfFreedom, 0);
  EXPECT_EQ(fit.disagreement, 0.0);
}

} // namespace
} // namespace dewpoint::tests
