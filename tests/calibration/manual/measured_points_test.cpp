// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/manual/interactive_pose.h"
#include "core/calibration/manual/measured_points.h"
#include "core/geometry/projector.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

Camera measuringCamera(const Eigen::Vector3d& position, const std::string& name) {
  Camera camera;
  camera.name = name;
  camera.intrinsics = {640, 480, 520.0, 515.0, 326.0, 231.0};
  camera.distortion = {-0.18, 0.05, 0.001, -0.0012, 0.0};
  camera.cameraFromWorld = lookAt(position, {0.1, 0.0, 0.3});
  return camera;
}

const std::vector<Eigen::Vector3d>& places() {
  static const std::vector<Eigen::Vector3d> kPlaces{
      {-0.8, -0.5, 0.0}, {0.7, -0.6, 0.0}, {0.9, 0.7, 0.0},  {-0.6, 0.8, 0.0},
      {0.2, 0.1, 0.75},  {-0.4, 0.2, 0.9}, {0.5, -0.2, 0.4}, {0.0, 0.6, 0.55}};
  return kPlaces;
}

/// The places as a tape and exact clicks would have them.
std::vector<MeasuredPoint> pointsSeenBy(const CameraRig& rig, std::size_t count) {
  std::vector<MeasuredPoint> points;
  for (std::size_t k = 0; k < count; ++k) {
    MeasuredPoint point;
    point.name = fmt::format("point {}", k + 1);
    point.world = places()[k];
    for (std::size_t c = 0; c < rig.size(); ++c) {
      point.clicks.push_back({static_cast<int>(c), Projector(rig[c]).project(places()[k]).value()});
    }
    points.push_back(std::move(point));
  }
  return points;
}

/// The cameras as they might be before: moved and turned.
CameraRig displaced(const CameraRig& rig) {
  CameraRig result;
  for (const Camera& camera : rig) {
    result.push_back(moved(rotated(camera, {0.2, -0.3, 0.1}, NudgeFrame::Camera), {0.4, -0.3, 0.2},
                           NudgeFrame::World));
  }
  return result;
}

double apart(const Camera& a, const Camera& b) {
  return (a.center() - b.center()).norm();
}

CameraRig twoCameras() {
  return {measuringCamera({-2.0, -3.0, 1.8}, "left"), measuringCamera({2.2, -2.5, 2.1}, "right")};
}

TEST(MeasuredPoints, ExactPointsGiveTheCamerasBack) {
  for (const std::size_t count : {4U, 6U, 8U}) {
    const CameraRig rig = twoCameras();
    const auto points = pointsSeenBy(rig, count);
    const PointSolution solution = solveFromPoints(displaced(rig), points);
    ASSERT_EQ(solution.cameras.size(), 2U);
    for (std::size_t c = 0; c < 2; ++c) {
      EXPECT_NE(solution.cameras[c].status, PoseStatus::TooFew);
      EXPECT_LT(apart(solution.rig[c], rig[c]), 1e-6) << count;
      EXPECT_FALSE(solution.cameras[c].proposal) << count;
    }
    EXPECT_LT(solution.rmsPx, 1e-5);
    EXPECT_FALSE(solution.isWorstPointWrong);
    EXPECT_EQ(solution.residuals.size(), 2 * count);
  }
}

TEST(MeasuredPoints, TheFocalLengthComesBackToo) {
  const CameraRig rig{measuringCamera({-2.0, -3.0, 1.8}, "left")};
  CameraRig wrong{zoomed(rig[0], 0.85)};
  PointSettings settings;
  settings.estimatesFocal = true;
  const PointSolution solution = solveFromPoints(wrong, pointsSeenBy(rig, 8), settings);
  EXPECT_NEAR(solution.rig[0].intrinsics.focalX, 520.0, 1e-3);
  EXPECT_LT(apart(solution.rig[0], rig[0]), 1e-4);
}

TEST(MeasuredPoints, AFocalLengthNeedsSixPoints) {
  const CameraRig rig{measuringCamera({-2.0, -3.0, 1.8}, "left")};
  const CameraRig wrong{zoomed(rig[0], 0.98)};
  PointSettings settings;
  settings.estimatesFocal = true;
  const auto focalFrom = [&](int count) {
    return solveFromPoints(wrong, pointsSeenBy(rig, static_cast<std::size_t>(count)), settings)
        .rig[0]
        .intrinsics.focalX;
  };
  EXPECT_EQ(focalFrom(kFewestPointsOfFocal - 1), wrong[0].intrinsics.focalX); // it is kept
  EXPECT_NEAR(focalFrom(kFewestPointsOfFocal), rig[0].intrinsics.focalX, 1e-2);
}

TEST(MeasuredPoints, ResidualsAreInPixelsAndMeters) {
  const CameraRig rig{measuringCamera({0.0, -3.0, 1.0}, "only")};
  auto points = pointsSeenBy(rig, 5);
  // A click 5 px beside, at the point's distance d: 5 d / f meters from the ray, roughly.
  points[2].clicks[0].pixel.x() += 5.0;
  const auto residuals = clickResiduals(rig, points);
  ASSERT_EQ(residuals.size(), 5U);
  EXPECT_NEAR(residuals[2].imageDistancePx, 5.0, 1e-9);
  const double distance = (points[2].world - rig[0].center()).norm();
  EXPECT_NEAR(residuals[2].rayDistance, 5.0 * distance / 520.0, 0.15 * 5.0 * distance / 520.0);
  EXPECT_LT(residuals[1].imageDistancePx, 1e-9);
  EXPECT_LT(residuals[1].rayDistance, 1e-9);
}

TEST(MeasuredPoints, TheMistypedPointIsNamed) {
  const CameraRig rig = twoCameras();
  auto points = pointsSeenBy(rig, 8);
  points[5].world.x() += 0.1; // 10 cm: the tape was read wrongly
  const PointSolution solution = solveFromPoints(displaced(rig), points);
  ASSERT_TRUE(solution.worstPoint);
  EXPECT_EQ(*solution.worstPoint, 5);
  EXPECT_TRUE(solution.isWorstPointWrong);
  points.erase(points.begin() + 5);
  EXPECT_LT(apart(solveFromPoints(displaced(rig), points).rig[0], rig[0]), 1e-6);
}

TEST(MeasuredPoints, APointIsElsewhereInFramesInWhichItWasNotClicked) {
  MeasuredPoint point;
  EXPECT_FALSE(isClickedOnlyInOtherFrames(point, 5)); // not clicked
  setClickIn(point, 0, {1.0, 2.0}, 5);
  EXPECT_FALSE(isClickedOnlyInOtherFrames(point, 5));
  EXPECT_TRUE(isClickedOnlyInOtherFrames(point, 6));
  setClickIn(point, 1, {3.0, 4.0}, 6);
  EXPECT_FALSE(isClickedOnlyInOtherFrames(point, 6)); // in one camera
  EXPECT_TRUE(isClickedOnlyInOtherFrames(point, 7));
  setClickIn(point, 1, {3.0, 4.0}); // nobody knows
  EXPECT_FALSE(isClickedOnlyInOtherFrames(point, 7));
}

TEST(MeasuredPoints, TapeErrorsDoNotShakeTheCameras) {
  const CameraRig rig = twoCameras();
  auto points = pointsSeenBy(rig, 8);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double way = k % 2 == 0 ? 0.003 : -0.003;
    points[k].world += Eigen::Vector3d(way, k % 3 == 0 ? -0.003 : 0.003, 0.0);
  }
  const PointSolution solution = solveFromPoints(displaced(rig), points);
  // 3 mm on 8 points around the middle: some millimeters at the cameras, 3.5 m away.
  EXPECT_LT(apart(solution.rig[0], rig[0]), 0.03);
  EXPECT_LT(solution.rmsPx, 2.0);
  EXPECT_FALSE(solution.isWorstPointWrong);
}

TEST(MeasuredPoints, WhatIsNotEnoughIsNamed) {
  const CameraRig rig{measuringCamera({0.0, -3.0, 1.0}, "only")};
  const auto few = solveFromPoints(displaced(rig), pointsSeenBy(rig, 3));
  EXPECT_EQ(few.cameras.at(0).status, PoseStatus::TooFew);
  EXPECT_TRUE(few.rig == displaced(rig)) << "it stays as it was";
  EXPECT_FALSE(few.hasSolvedCamera());
  const auto least = solveFromPoints(displaced(rig), pointsSeenBy(rig, kFewestPointsOfPose));
  EXPECT_NE(least.cameras.at(0).status, PoseStatus::TooFew);
  std::vector<MeasuredPoint> line;
  for (int k = 0; k < 5; ++k) {
    const Eigen::Vector3d place(0.3 * k - 0.6, 0.1 * k, 0.0);
    line.push_back({fmt::format("p{}", k), place, {{0, Projector(rig[0]).project(place).value()}}});
  }
  EXPECT_EQ(solveFromPoints(rig, line).cameras.at(0).status, PoseStatus::Collinear);
  EXPECT_TRUE(solveFromPoints(rig, {}).cameras.empty());
}

TEST(MeasuredPoints, AFarSmallPlaneIsAmbiguous) {
  CameraRig rig{measuringCamera({0.0, -12.0, 8.0}, "far")};
  std::vector<MeasuredPoint> plane;
  for (const auto& [x, y] : {std::pair(-0.1, -0.1), {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}}) {
    const Eigen::Vector3d place(x, y, 0.0);
    plane.push_back(
        {fmt::format("{} {}", x, y), place, {{0, Projector(rig[0]).project(place).value()}}});
  }
  EXPECT_EQ(solveFromPoints(rig, plane).cameras.at(0).status, PoseStatus::Ambiguous);
  // Seen from near, perspective decides.
  const auto near = solveFromPoints({measuringCamera({0, -3, 2}, "near")},
                                    pointsSeenBy({measuringCamera({0, -3, 2}, "near")}, 4));
  EXPECT_EQ(near.cameras.at(0).status, PoseStatus::None);
}

class Symmetries : public testing::TestWithParam<int> {};

TEST_P(Symmetries, ATurnedOrMirroredStreamIsNamed) {
  const ImageSymmetry& wanted = imageSymmetries()[static_cast<std::size_t>(GetParam())];
  const CameraRig rig = twoCameras();
  // What arrives must be transformed by `wanted` to be what the camera sees: clicks are where the
  // inverse puts them, and nobody knew when the intrinsics were made.
  const ImageSymmetry arrived =
      wanted.isMirrored ? wanted : ImageSymmetry{(360 - wanted.rotateDegrees) % 360, false};
  auto points = pointsSeenBy(rig, 8);
  CameraRig streams = displaced(rig);
  streams[1] = transformed(arrived, streams[1]);
  for (MeasuredPoint& point : points) {
    point.clicks[1].pixel = transformed(arrived, point.clicks[1].pixel, 640, 480);
  }
  const PointSolution solution = solveFromPoints(streams, points);
  EXPECT_FALSE(solution.cameras[0].proposal);
  if (wanted == ImageSymmetry{}) {
    EXPECT_FALSE(solution.cameras[1].proposal);
    return;
  }
  ASSERT_TRUE(solution.cameras[1].proposal);
  EXPECT_EQ(solution.cameras[1].proposal->symmetry, wanted)
      << solution.cameras[1].proposal->symmetry.rotateDegrees;
  EXPECT_LT(solution.cameras[1].proposal->rmsPx, 0.01);
  // As proposed, everything fits.
  const Camera before = streams[1];
  streams[1] = transformed(wanted, before);
  for (MeasuredPoint& point : points) {
    point.clicks[1].pixel = transformed(wanted, point.clicks[1].pixel, before.intrinsics.width,
                                        before.intrinsics.height);
  }
  const PointSolution fixed = solveFromPoints(streams, points);
  EXPECT_LT(apart(fixed.rig[1], rig[1]), 1e-6);
  EXPECT_FALSE(fixed.cameras[1].proposal);
}

INSTANTIATE_TEST_SUITE_P(All, Symmetries, testing::Range(0, 8));

/// The same room with z down: x as before, y and z the other way.
void turnWorld(CameraRig& rig, std::vector<MeasuredPoint>& points) {
  const Eigen::Matrix3d half = Eigen::Vector3d(1.0, -1.0, -1.0).asDiagonal();
  for (Camera& camera : rig) {
    camera.cameraFromWorld.linear() = camera.cameraFromWorld.linear() * half;
  }
  for (MeasuredPoint& point : points) {
    point.world = half * point.world;
  }
}

TEST(MeasuredPoints, UprightImagesAreNotUpsideDownWhereZPointsDown) {
  for (const std::size_t count : {8U, 4U}) { // in space, and on the floor
    CameraRig rig = twoCameras();
    auto points = pointsSeenBy(rig, count);
    turnWorld(rig, points);
    const PointSolution solution = solveFromPoints(rig, points);
    ASSERT_EQ(solution.cameras.size(), 2U);
    for (const CameraFromPoints& camera : solution.cameras) {
      EXPECT_EQ(camera.status, PoseStatus::None);
      EXPECT_FALSE(camera.proposal) << count;
    }
  }
}

TEST(MeasuredPoints, AMirroredFloorIsSeenFromBelow) {
  // Points of one plane fit mirrored as well; but nobody looks through the floor.
  const CameraRig rig{measuringCamera({-2.0, -3.0, 1.8}, "left")};
  auto points = pointsSeenBy(rig, 4);
  for (MeasuredPoint& point : points) {
    point.clicks[0].pixel = transformed({0, true}, point.clicks[0].pixel, 640, 480);
  }
  const CameraRig stream{transformed({0, true}, rig[0])};
  const PointSolution solution = solveFromPoints(stream, points);
  ASSERT_TRUE(solution.cameras[0].proposal);
  EXPECT_TRUE(solution.cameras[0].proposal->symmetry.isMirrored);
}

} // namespace
} // namespace dewpoint::tests
