// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/camera.h"
#include "core/geometry/projector.h"
#include "tests/geometry/webcam.h"

#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace dewpoint::tests {
namespace {

/// A camera whose axes are the world's, for hand computation.
Camera plain(const std::array<double, 8>& distortion = {}) {
  Camera camera;
  camera.intrinsics = {320, 240, 100.0, 200.0, 160.0, 120.0};
  camera.distortion = distortion;
  return camera;
}

/// World points in front of the camera, up to `extent` off the axis at unit depth.
std::vector<Eigen::Vector3d> pointsInFront(const Camera& camera, double extent) {
  std::vector<Eigen::Vector3d> points;
  const Eigen::Isometry3d worldFromCamera = camera.cameraFromWorld.inverse();
  for (int i = -4; i <= 4; ++i) {
    for (int j = -4; j <= 4; ++j) {
      const double depth = 0.3 + 0.17 * (i + j + 8);
      points.push_back(worldFromCamera *
                       Eigen::Vector3d(extent * i / 4 * depth, extent * j / 4 * depth, depth));
    }
  }
  return points;
}

void expectAsOpenCv(const Camera& camera, int coefficients, double extent) {
  const std::vector<Eigen::Vector3d> points = pointsInFront(camera, extent);
  std::vector<cv::Point3d> objects;
  for (const Eigen::Vector3d& p : points) {
    objects.emplace_back(p.x(), p.y(), p.z());
  }
  const Intrinsics& in = camera.intrinsics;
  const cv::Matx33d matrix(in.focalX, 0, in.centerX, 0, in.focalY, in.centerY, 0, 0, 1);
  cv::Matx33d rotation;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      rotation(row, column) = camera.cameraFromWorld.linear()(row, column);
    }
  }
  cv::Vec3d rotationVector;
  cv::Rodrigues(rotation, rotationVector);
  const Eigen::Vector3d t = camera.cameraFromWorld.translation();
  const std::vector<double> distortion(camera.distortion.begin(),
                                       camera.distortion.begin() + coefficients);
  std::vector<cv::Point2d> expected;
  const cv::Vec3d translation(t.x(), t.y(), t.z());
  if (camera.lens == LensModel::Fisheye) {
    cv::fisheye::projectPoints(objects, expected, rotationVector, translation, matrix, distortion);
  } else {
    cv::projectPoints(objects, rotationVector, translation, matrix, distortion, expected);
  }
  const Projector projector(camera);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto pixel = projector.project(points[i]);
    ASSERT_TRUE(pixel.has_value()) << "point " << i;
    // The models are the same, so only rounding is left.
    EXPECT_NEAR(pixel->x(), expected[i].x, 1e-8) << "point " << i;
    EXPECT_NEAR(pixel->y(), expected[i].y, 1e-8) << "point " << i;
  }
}

TEST(Projector, AgreesWithOpenCvWithoutDistortion) {
  expectAsOpenCv(webcam(), 0, 1.5);
}

TEST(Projector, AgreesWithOpenCvWithFiveCoefficients) {
  expectAsOpenCv(webcam({-0.28, 0.07, 0.0012, -0.0008, 0.004}), 5, 0.5);
}

TEST(Projector, AgreesWithOpenCvWithEightCoefficients) {
  // Rational: the denominator grows with the radius, a mild barrel.
  expectAsOpenCv(webcam({0.12, 0.03, -0.0007, 0.0011, 0.002, 0.2, 0.04, 0.003}), 8, 0.6);
}

TEST(Projector, AgreesWithOpenCvsFisheye) {
  Camera camera = webcam({-0.02, 0.004, -0.001, 0.0002});
  camera.lens = LensModel::Fisheye;
  expectAsOpenCv(camera, 4, 3.0); // 72 degrees off the axis
}

TEST(Projector, FollowsThePinholeByHand) {
  // (0.2, -0.1, 2): column 100 * 0.1 + 160, row 200 * -0.05 + 120.
  const auto pixel = Projector(plain()).project({0.2, -0.1, 2.0});
  ASSERT_TRUE(pixel.has_value());
  EXPECT_NEAR(pixel->x(), 170.0, 1e-12);
  EXPECT_NEAR(pixel->y(), 110.0, 1e-12);
}

TEST(Projector, AnswersOutsideTheImageToo) {
  const auto pixel = Projector(plain()).project({-10.0, 0.0, 1.0}); // 100 * -10 + 160
  ASSERT_TRUE(pixel.has_value());
  EXPECT_NEAR(pixel->x(), -840.0, 1e-9);
}

TEST(Projector, RefusesWhatIsNotInFront) {
  const Projector projector(plain());
  EXPECT_FALSE(projector.project({0.0, 0.0, -1.0}).has_value());
  EXPECT_FALSE(projector.project({0.1, 0.1, 0.0}).has_value());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(projector.project({0.1, 0.1, nan}).has_value());
}

TEST(Projector, RefusesBeyondTheFoldBackOfARealCalibration) {
  // d(r f)/dr = 1 + 3 k1 s + 5 k2 s^2 + 7 k3 s^3 is zero at s = r^2 = 0.3443, so at r = 0.5868.
  const Projector projector(plain({-0.014, 1.4193, -0.0035, -0.0036, -6.394}));
  for (int i = 0; i < 36; ++i) {
    const double angle = i * std::numbers::pi / 18.0;
    const Eigen::Vector3d direction(std::cos(angle), std::sin(angle), 0.0);
    const auto at = [&](double r) {
      return projector.project(direction * r + Eigen::Vector3d(0, 0, 1));
    };
    EXPECT_TRUE(at(0.0).has_value());
    EXPECT_TRUE(at(0.586).has_value());
    EXPECT_FALSE(at(0.588).has_value());
    // Where the unguarded polynomial crosses zero (r near 0.79), it would put this in the middle
    // of the image.
    EXPECT_FALSE(at(0.79).has_value());
    EXPECT_FALSE(at(5.0).has_value());
  }
}

TEST(Projector, GrowsOutwardUpToTheFoldBack) {
  const Projector projector(plain({-0.014, 1.4193, 0.0, 0.0, -6.394}));
  double previous = -1.0;
  for (double r = 0.0; r < 0.5867; r += 0.001) {
    const auto pixel = projector.project({r, 0.0, 1.0});
    ASSERT_TRUE(pixel.has_value()) << r;
    ASSERT_GT(pixel->x(), previous) << r;
    previous = pixel->x();
  }
}

TEST(Projector, RefusesBeyondThePoleOfTheRationalModel) {
  // 1 / (1 - 0.5 s): always growing up to the pole at s = 2, and turned over behind it.
  const Projector projector(plain({0, 0, 0, 0, 0, -0.5, 0, 0}));
  EXPECT_TRUE(projector.project({1.41, 0.0, 1.0}).has_value());
  EXPECT_FALSE(projector.project({1.42, 0.0, 1.0}).has_value());
  EXPECT_FALSE(projector.project({3.0, 0.0, 1.0}).has_value());
}

TEST(Projector, HasNoLimitWhereTheModelNeverFolds) {
  EXPECT_TRUE(Projector(plain({0.1, 0, 0, 0, 0})).project({1000.0, 0.0, 1.0}).has_value());
  EXPECT_TRUE(Projector(plain()).project({1000.0, 0.0, 1.0}).has_value());
}

TEST(LookAt, PutsTheTargetInTheCenterAndUpAtTheTop) {
  const Eigen::Vector3d position(1.0, -2.0, 0.5);
  const Eigen::Vector3d target(0.2, 0.3, 0.1);
  Camera camera = plain();
  camera.cameraFromWorld = lookAt(position, target);
  EXPECT_LT((camera.center() - position).norm(), 1e-12);
  EXPECT_LT((camera.opticalAxis() - (target - position).normalized()).norm(), 1e-12);
  const Projector projector(camera);
  const auto middle = projector.project(target);
  const auto above = projector.project(target + Eigen::Vector3d(0, 0, 0.1));
  ASSERT_TRUE(middle && above);
  EXPECT_NEAR(middle->x(), 160.0, 1e-9);
  EXPECT_NEAR(middle->y(), 120.0, 1e-9);
  EXPECT_NEAR(above->x(), 160.0, 1e-9);
  EXPECT_LT(above->y(), 120.0); // rows count downward
}

TEST(LookAt, IsARightHandedRotation) {
  const Eigen::Matrix3d r = lookAt({1, 2, 3}, {0, 0, 0}, {0, 0, 1}, 0.7).linear();
  EXPECT_LT((r * r.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-12);
  EXPECT_NEAR(r.determinant(), 1.0, 1e-12);
}

TEST(LookAt, RollTurnsTheCameraClockwiseSeenFromBehind) {
  // Looking along +x the world's up is the camera's -y; a quarter turn from x (right) to y (down)
  // leaves the world's up on the camera's left.
  const Eigen::Isometry3d pose = lookAt({0, 0, 0}, {1, 0, 0}, {0, 0, 1}, std::numbers::pi / 2);
  EXPECT_LT((pose.linear() * Eigen::Vector3d::UnitZ() - Eigen::Vector3d(-1, 0, 0)).norm(), 1e-12);
}

TEST(LookAt, ChoosesAnAxisWhenLookingAlongUp) {
  const Eigen::Isometry3d pose = lookAt({0, 0, 2}, {0, 0, 0});
  EXPECT_TRUE(pose.matrix().allFinite());
  EXPECT_NEAR(pose.linear().determinant(), 1.0, 1e-12);
  EXPECT_LT((pose * Eigen::Vector3d(0, 0, 0) - Eigen::Vector3d(0, 0, 2)).norm(), 1e-12);
}

} // namespace
} // namespace dewpoint::tests
