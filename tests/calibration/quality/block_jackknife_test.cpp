// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/statistics.h"
#include "core/calibration/board/intrinsics_covariance.h"
#include "core/calibration/quality/block_jackknife.h"
#include "core/calibration/quality/board_accuracy.h"
#include "tests/calibration/board_views.h"
#include "tests/calibration/waved_rig.h"

#include <cmath>
#include <limits>

namespace dewpoint::tests {
namespace {

// 95 % of the length of a normal vector: 1.960 along one axis, 2.448 in a plane, 2.795 in space
// (square roots of the chi-square distribution's quantiles).
TEST(BlockJackknife, BoundsTheLengthOfAVector) {
  const auto bound = [](double x, double y, double z) {
    return lengthBound95(Eigen::Vector3d(x, y, z).asDiagonal().toDenseMatrix());
  };
  EXPECT_NEAR(bound(1.0, 0.0, 0.0), 1.960, 0.03);
  EXPECT_NEAR(bound(1.0, 1.0, 0.0), 2.448, 0.03);
  EXPECT_NEAR(bound(1.0, 1.0, 1.0), 2.795, 0.03);
  EXPECT_NEAR(bound(4.0, 4.0, 4.0), 2.0 * 2.795, 0.06);
  EXPECT_EQ(bound(0.0, 0.0, 0.0), 0.0);
}

// The mean of ten numbers: the jackknife's variance is that of the mean, s² / 10.
TEST(BlockJackknife, OfAMeanIsItsKnownVariance) {
  const Eigen::RowVectorXd numbers =
      (Eigen::RowVectorXd(10) << 3.0, 1.0, 4.0, 1.0, 5.0, 9.0, 2.0, 6.0, 5.0, 3.0).finished();
  Eigen::MatrixXd without(1, 10);
  for (Eigen::Index k = 0; k < 10; ++k) {
    without(0, k) = (numbers.sum() - numbers[k]) / 9.0;
  }
  BlockJackknife jackknife;
  jackknife.rigs.resize(10);
  const double widened = studentQuantile95(9.0) / 1.96;
  const double variance = (numbers.array() - numbers.mean()).square().sum() / 9.0 / 10.0;
  EXPECT_NEAR(jackknifeDeviations(without, jackknife.deviationScale()).squaredNorm(),
              widened * widened * variance, 1e-9);
  jackknife.rigs.resize(3);
  EXPECT_EQ(jackknife.deviationScale(), 0.0); // too few to tell
}

/// Frames of one camera that was late share their errors; the covariance takes each corner as an
/// error of its own.
TEST(BlockJackknife, ErrorsThatFramesShareWidenEachCamera) {
  using namespace simulated;
  const CameraRig truth = rig(5);
  WandProblem problem = wave(truth, 5, 0.05, 400);
  for (MarkerObservation& view : problem.views[2]) {
    const double phase = 0.8 * view.time;
    view.pixel += 0.4 * Eigen::Vector2d(std::sin(phase), std::cos(1.3 * phase));
  }
  problem.initialRig = moved(truth, 0.1, 0.05, 5);
  const auto result = calibrateFromWand(problem);
  ASSERT_TRUE(result) << errorSentence(result.error());
  const auto accuracy = assessWand(*result, {});
  ASSERT_TRUE(accuracy);
  ASSERT_EQ(accuracy->cameras.size(), truth.size());
  const auto stated = [&](std::size_t camera) {
    return result->bundle.residualToSigmaRatio * centerSigma(result->bundle.covariance, camera);
  };
  EXPECT_GT(accuracy->cameras[2].positionSigma, 1.5 * stated(2));
  EXPECT_GT(accuracy->cameras[2].positionSigma, accuracy->cameras[0].positionSigma);
}

IntrinsicsRequest lensRequest(int first, int end) {
  IntrinsicsRequest request;
  request.board = boardOf("chessboard:9x6:0.025");
  const Camera camera = testCamera();
  const auto poses = variedPoses(request.board, camera, 20, 3);
  for (int k = 0; k < 20; ++k) {
    if (k < first || k >= end) {
      request.views.push_back(viewOf(request.board, camera, poses[static_cast<std::size_t>(k)], 0.1,
                                     static_cast<std::uint32_t>(k)));
    }
  }
  request.width = camera.intrinsics.width;
  request.height = camera.intrinsics.height;
  request.pixelShape = PixelShape::Square;
  return request;
}

TEST(BlockJackknife, ALensWithoutSomeViewsIsThatOfACalibrationWithoutThem) {
  const auto whole = calibrateIntrinsics(lensRequest(0, 0));
  const auto without = calibrateIntrinsics(lensRequest(4, 8));
  ASSERT_TRUE(whole) << errorSentence(whole.error());
  ASSERT_TRUE(without) << errorSentence(without.error());
  ASSERT_EQ(whole->viewNormalEquations.size(), 20U);
  const Camera found = lensWithoutViews(*whole, 4, 8);
  const double sigma = whole->parameters[0].sigma;
  EXPECT_NEAR(found.intrinsics.focalX, without->camera.intrinsics.focalX, 0.3 * sigma);
  EXPECT_NEAR(found.intrinsics.centerX, without->camera.intrinsics.centerX,
              0.3 * whole->parameters[1].sigma);
  EXPECT_EQ(lensWithoutViews(*whole, 100, 200).intrinsics.focalX, whole->camera.intrinsics.focalX);
}

TEST(BlockJackknife, VariancesAreWidenedParameterByParameter) {
  const Eigen::Matrix2d stated = (Eigen::Matrix2d() << 4.0, 1.0, 1.0, 1.0).finished();
  const Eigen::Matrix2d found = (Eigen::Matrix2d() << 1.0, 0.0, 0.0, 9.0).finished();
  const Eigen::MatrixXd wider = widenedCovariance(stated, found);
  EXPECT_DOUBLE_EQ(wider(0, 0), 4.0); // not narrowed
  EXPECT_DOUBLE_EQ(wider(1, 1), 9.0);
  EXPECT_DOUBLE_EQ(wider(0, 1), 3.0); // the correlation, 0.5, is kept
  EXPECT_EQ(widenedCovariance(stated, {}), Eigen::MatrixXd(stated));
}

} // namespace
} // namespace dewpoint::tests
