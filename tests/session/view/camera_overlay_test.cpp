// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/random.h"
#include "core/geometry/sphere_image.h"
#include "core/session/view/camera_overlay.h"
#include "tests/session/fake_recording.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <numbers>

namespace dewpoint::tests {
namespace {

TrackSnapshot snapshotWithRig() {
  TrackSnapshot snapshot;
  snapshot.rig = std::make_shared<const CameraRig>(test::twoCameras());
  return snapshot;
}

TargetSnapshot threeParticles() {
  TargetSnapshot target;
  target.particles.resize(3, 3);
  target.particles << 0.0, 0.0, 0.1, //
      0.05, 0.02, 0.12,              //
      0.0, -0.8, 0.1;                // behind the left camera, in front of the right one
  target.weights.resize(3);
  target.weights << 0.2, 0.5, 0.3;
  return target;
}

TEST(CameraOverlay, ProjectsParticlesInFrontOfTheCamera) {
  const auto snapshot = snapshotWithRig();
  const auto target = threeParticles();
  const auto left = cameraOverlay(snapshot, 0, target);
  ASSERT_EQ(left.particles.size(), 2U);
  ASSERT_EQ(left.weights.size(), 2U);
  EXPECT_FLOAT_EQ(left.weights[0], 0.4F); // 0.2 of the largest, 0.5
  EXPECT_FLOAT_EQ(left.weights[1], 1.0F);
  const Projector projector((*snapshot.rig)[0]);
  for (Eigen::Index i = 0; i < 2; ++i) {
    const Eigen::Vector3d point = target.particles.row(i).matrix().transpose();
    EXPECT_TRUE(left.particles[static_cast<std::size_t>(i)].isApprox(
        projector.project(point)->cast<float>()));
  }
  EXPECT_EQ(cameraOverlay(snapshot, 1, target).particles.size(), 3U);
}

TEST(CameraOverlay, ThinsTheParticlesOfVeryManyTargets) {
  auto snapshot = snapshotWithRig();
  TargetSnapshot target;
  target.particles = Eigen::ArrayXXd::Constant(500, 3, 0.1);
  target.weights = Eigen::ArrayXd::Constant(500, 1.0 / 500.0);
  snapshot.targets.assign(20, target);
  EXPECT_EQ(cameraOverlay(snapshot, 0, target).particles.size(), 500U);
  snapshot.targets.assign(1600, target);
  const auto overlay = cameraOverlay(snapshot, 0, target);
  EXPECT_EQ(overlay.particles.size(), 7U); // every 80th
  EXPECT_EQ(overlay.weights.size(), 7U);
}

TEST(CameraOverlay, IsEmptyWithoutRigCameraOrEstimate) {
  const auto target = threeParticles();
  EXPECT_TRUE(cameraOverlay(TrackSnapshot{}, 0, target).particles.empty());
  EXPECT_TRUE(cameraOverlay(snapshotWithRig(), -1, target).particles.empty());
  EXPECT_TRUE(cameraOverlay(snapshotWithRig(), 2, target).particles.empty());
  const auto overlay = cameraOverlay(snapshotWithRig(), 0, target);
  EXPECT_FALSE(overlay.estimate || overlay.ellipse || overlay.truth);
}

// An ellipsoid with three equal axes is a ball, whose outline is known otherwise.
TEST(CameraOverlay, OutlinesWhatIsNoBall) {
  constexpr double kRadius = 0.06;
  const auto snapshot = snapshotWithRig();
  TargetSnapshot target = threeParticles();
  auto& sphere = std::get<SphereEstimate>(target.estimate);
  sphere.particleCount = 3;
  sphere.mean = {0.02, 0.01, 0.1};
  sphere.covariance = 1e-6 * Eigen::Matrix3d::Identity();
  EXPECT_FALSE(cameraOverlay(snapshot, 0, target).outline); // of a ball
  sphere.extent = kRadius * kRadius * Eigen::Matrix3d::Identity();
  const auto overlay = cameraOverlay(snapshot, 0, target);
  ASSERT_TRUE(overlay.outline);
  const auto ball = SphereProjector((*snapshot.rig)[0]).project(sphere.mean, kRadius);
  ASSERT_TRUE(ball);
  EXPECT_LT((overlay.outline->center - ball->center).norm(), 0.5);
  EXPECT_NEAR(std::sqrt(overlay.outline->semiMajorAxis * overlay.outline->semiMinorAxis),
              ball->radius, 0.01 * ball->radius);
  // Twice as long along the image's columns.
  const Eigen::Vector3d across = (*snapshot.rig)[0].cameraFromWorld.linear().row(0);
  *sphere.extent += 3.0 * kRadius * kRadius * across * across.transpose();
  const auto longer = cameraOverlay(snapshot, 0, target);
  ASSERT_TRUE(longer.outline);
  EXPECT_NEAR(longer.outline->semiMajorAxis, 2.0 * longer.outline->semiMinorAxis,
              0.1 * longer.outline->semiMinorAxis);
  EXPECT_NEAR(std::abs(std::cos(longer.outline->angleRadians)), 1.0, 0.02);
}

TEST(CameraOverlay, HasTheParticleOfHighestWeight) {
  const auto snapshot = snapshotWithRig();
  TargetSnapshot target = threeParticles();
  auto& sphere = std::get<SphereEstimate>(target.estimate);
  sphere.best = {0.05, 0.02, 0.12};
  EXPECT_FALSE(cameraOverlay(snapshot, 0, target).bestParticle); // of no particles
  sphere.particleCount = 3;
  const auto best = cameraOverlay(snapshot, 0, target).bestParticle;
  ASSERT_TRUE(best);
  EXPECT_TRUE(best->isApprox(*Projector((*snapshot.rig)[0]).project(sphere.best)));
  target.estimate = PersonEstimate{};
  EXPECT_FALSE(cameraOverlay(snapshot, 0, target).bestParticle);
}

TEST(CameraOverlay, LightParticlesFarAwayAreNotOfTheCloud) {
  CameraOverlay overlay;
  overlay.estimate = Eigen::Vector2d(100.0, 50.0);
  for (int k = 0; k < 10; ++k) {
    overlay.particles.emplace_back(100.0F + 0.1F * static_cast<float>(k), 50.0F);
    overlay.weights.push_back(1.0F);
  }
  EXPECT_NEAR(cloudRadius(overlay), 0.8, 1e-5); // nine of ten
  overlay.particles.emplace_back(100.0F, 300.0F);
  overlay.weights.push_back(0.05F);
  EXPECT_NEAR(cloudRadius(overlay), 0.9, 1e-5);
  overlay.estimate.reset();
  EXPECT_EQ(cloudRadius(overlay), 0.0);
}

TEST(CameraOverlay, EllipseIsThatOfASampledGaussian) {
  const auto snapshot = snapshotWithRig();
  TargetSnapshot target;
  std::get<SphereEstimate>(target.estimate).particleCount = 1;
  std::get<SphereEstimate>(target.estimate).mean = {0.03, 0.02, 0.08};
  Eigen::Matrix3d root; // standard deviations of up to 1 cm, at 0.6 m: nearly linear
  root << 0.010, 0.0, 0.0, 0.004, 0.006, 0.0, -0.003, 0.002, 0.003;
  std::get<SphereEstimate>(target.estimate).covariance = root * root.transpose();
  target.truth = Eigen::Vector3d(0.01, 0.0, 0.1);
  for (int camera = 0; camera < 2; ++camera) {
    const Projector projector((*snapshot.rig)[static_cast<std::size_t>(camera)]);
    constexpr int kSamples = 100000; // standard error of a standard deviation: 0.2 %
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    const RandomStream stream(1, 0, 0, RandomPurpose::Simulation);
    for (std::uint32_t i = 0; i < kSamples; ++i) {
      const auto normal = stream.normal4(i);
      const Eigen::Vector3d point = std::get<SphereEstimate>(target.estimate).mean +
                                    root * Eigen::Vector3d(normal[0], normal[1], normal[2]);
      const Eigen::Vector2d pixel = projector.project(point).value();
      sum += pixel;
      squares += pixel * pixel.transpose();
    }
    const Eigen::Vector2d mean = sum / kSamples;
    const Eigen::Matrix2d covariance = squares / kSamples - mean * mean.transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(covariance);
    const auto overlay = cameraOverlay(snapshot, camera, target);
    ASSERT_TRUE(overlay.ellipse && overlay.estimate && overlay.truth);
    // 5.991: the 95 % quantile of chi-squared with 2 degrees of freedom (any table). 2 %: sampling
    // and the square of 1 cm / 0.6 m.
    const double major = std::sqrt(5.991 * solver.eigenvalues()[1]);
    const double minor = std::sqrt(5.991 * solver.eigenvalues()[0]);
    EXPECT_NEAR(overlay.ellipse->semiMajorAxis, major, 0.02 * major);
    EXPECT_NEAR(overlay.ellipse->semiMinorAxis, minor, 0.02 * minor);
    const Eigen::Vector2d along(std::cos(overlay.ellipse->angleRadians),
                                std::sin(overlay.ellipse->angleRadians));
    EXPECT_GT(std::abs(along.dot(solver.eigenvectors().col(1))), std::cos(0.05));
    EXPECT_TRUE(overlay.ellipse->center.isApprox(
        *projector.project(std::get<SphereEstimate>(target.estimate).mean)));
    EXPECT_TRUE(overlay.estimate->isApprox(
        *projector.project(std::get<SphereEstimate>(target.estimate).mean)));
    EXPECT_TRUE(overlay.truth->isApprox(*projector.project(*target.truth)));
  }
}

TEST(CameraOverlay, RoundCloudOnTheAxisIsACircle) {
  const auto snapshot = snapshotWithRig();
  TargetSnapshot target;
  std::get<SphereEstimate>(target.estimate).particleCount = 1;
  std::get<SphereEstimate>(target.estimate).mean =
      test::kBall; // on both optical axes, 0.6 m away, focal length 150 px
  std::get<SphereEstimate>(target.estimate).covariance = 1e-4 * Eigen::Matrix3d::Identity();
  const auto overlay = cameraOverlay(snapshot, 0, target);
  ASSERT_TRUE(overlay.ellipse);
  const double radius = std::sqrt(5.991) * 0.01 * 150.0 / 0.6;
  EXPECT_NEAR(overlay.ellipse->semiMajorAxis, radius, 0.001 * radius);
  EXPECT_NEAR(overlay.ellipse->semiMinorAxis, radius, 0.001 * radius);
}

TEST(CameraOverlay, NoEllipseWithoutAFiniteCovarianceOrBehindTheCamera) {
  const auto snapshot = snapshotWithRig();
  TargetSnapshot target;
  std::get<SphereEstimate>(target.estimate).particleCount = 1;
  std::get<SphereEstimate>(target.estimate).mean = test::kBall;
  std::get<SphereEstimate>(target.estimate).covariance(0, 0) = std::nan("");
  EXPECT_FALSE(cameraOverlay(snapshot, 0, target).ellipse);
  EXPECT_TRUE(cameraOverlay(snapshot, 0, target).estimate);
  std::get<SphereEstimate>(target.estimate).covariance.setIdentity();
  std::get<SphereEstimate>(target.estimate).mean = {0.0, -0.9, 0.1};
  EXPECT_FALSE(cameraOverlay(snapshot, 0, target).ellipse);
  EXPECT_FALSE(cameraOverlay(snapshot, 0, target).estimate);
}

} // namespace
} // namespace dewpoint::tests
