// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/planning/camera_placement.h"
#include "core/calibration/planning/rig_map.h"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

namespace dewpoint::tests {
namespace {

const Eigen::AlignedBox3d kRoom(Eigen::Vector3d(-2, -2, 0), Eigen::Vector3d(2, 2, 2));

Camera lens() {
  return idealCamera("camera", 640, 480, std::numbers::pi / 2.0);
}

Camera at(const Eigen::Vector3d& place) {
  Camera camera = lens();
  camera.cameraFromWorld = lookAt(place, kRoom.center());
  return camera;
}

PlacementSettings settings() {
  PlacementSettings settings;
  settings.volume = kRoom;
  return settings;
}

/// The covariance of a point from a pinhole camera's image of it at `pixelSigma`, by hand: of
/// (u, v) = f (x, y) / z the derivatives are f / z [1 0 -x/z; 0 1 -y/z] in camera axes. Nothing
/// where the image does not show it.
std::optional<Eigen::Matrix3d> informationOf(const Camera& camera, const Eigen::Vector3d& point,
                                             double pixelSigma) {
  const Intrinsics& in = camera.intrinsics;
  const Eigen::Vector3d there = camera.cameraFromWorld * point;
  const double u = in.focalX * there.x() / there.z() + in.centerX;
  const double v = in.focalY * there.y() / there.z() + in.centerY;
  if (there.z() <= 0.0 || u < -0.5 || u > in.width - 0.5 || v < -0.5 || v > in.height - 0.5) {
    return std::nullopt;
  }
  Eigen::Matrix<double, 2, 3> byCamera;
  byCamera << in.focalX, 0.0, -in.focalX * there.x() / there.z(), 0.0, in.focalY,
      -in.focalY * there.y() / there.z();
  const Eigen::Matrix<double, 2, 3> byPoint =
      byCamera / there.z() * camera.cameraFromWorld.linear() / pixelSigma;
  return byPoint.transpose() * byPoint;
}

/// Share of the cells of the room whose center at least two cameras show to 5 mm in the worst
/// direction; without anything of the product's maps.
double fractionWithin(const CameraRig& rig) {
  const VolumeGrid grid = gridOver(kRoom, 900);
  int good = 0;
  for (std::size_t cell = 0; cell < grid.cellCount(); ++cell) {
    const auto x = int(cell % std::size_t(grid.cellsPerAxis[0]));
    const auto y =
        int(cell / std::size_t(grid.cellsPerAxis[0]) % std::size_t(grid.cellsPerAxis[1]));
    const auto z = int(cell / std::size_t(grid.cellsPerAxis[0] * grid.cellsPerAxis[1]));
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    int seeing = 0;
    for (const Camera& camera : rig) {
      if (const auto one = informationOf(camera, grid.center(x, y, z), 0.5)) {
        sum += *one;
        ++seeing;
      }
    }
    // The largest variance is the inverse of the smallest information.
    const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvalues()[0];
    good += seeing >= 2 && least >= 1.0 / (0.005 * 0.005) ? 1 : 0;
  }
  return double(good) / double(grid.cellCount());
}

/// Two cells of 864, for those on the bound: the map takes differences of a finite step.
constexpr double kTwoCells = 2.0 / 864.0;

bool onWallOrCeiling(const Eigen::Vector3d& place) {
  const auto near = [](double a, double b) { return std::abs(a - b) < 1e-9; };
  const bool wall = near(std::abs(place.x()), 2.0) || near(std::abs(place.y()), 2.0);
  return place.z() >= 1.0 - 1e-9 && (wall || near(place.z(), 2.0));
}

TEST(CameraPlacement, AnIdealCameraHasItsFieldOfView) {
  // 90 degrees: the focal length is half of the width.
  EXPECT_NEAR(lens().intrinsics.focalX, 320.0, 1e-9);
  EXPECT_NEAR(lens().intrinsics.centerX, 319.5, 1e-9);
}

TEST(CameraPlacement, ASecondCameraLooksAcrossTheFirst) {
  // Of two cameras at one distance, the error across both rays is least at right angles; on the
  // line through both there is none. Anything between 45 and 135 degrees is near the best.
  const CameraRig rig{at({-2, 0, 1.5})};
  const auto found = placeCamera(rig, lens(), settings());
  ASSERT_TRUE(found) << errorSentence(found.error());
  EXPECT_TRUE(onWallOrCeiling(found->camera.center())) << found->camera.center().transpose();
  const double cosine = found->camera.opticalAxis().dot(rig[0].opticalAxis());
  EXPECT_LT(std::abs(cosine), std::cos(std::numbers::pi / 4.0));
  EXPECT_EQ(found->goodVolumeFractionBefore, 0.0); // one camera triangulates nothing
  const CameraRig across{rig[0], at({0, -2, 1.5})};
  EXPECT_GE(found->goodVolumeFractionAfter, fractionWithin(across) - kTwoCells);
}

TEST(CameraPlacement, IsNoWorseThanPlacesByHand) {
  const CameraRig rig{at({-2, -2, 2}), at({2, -2, 2})};
  const auto found = placeCamera(rig, lens(), settings());
  ASSERT_TRUE(found);
  const auto share = [&](const Camera& added) {
    CameraRig with = rig;
    with.push_back(added);
    return fractionWithin(with);
  };
  EXPECT_NEAR(share(found->camera), found->goodVolumeFractionAfter, kTwoCells);
  EXPECT_NEAR(fractionWithin(rig), found->goodVolumeFractionBefore, kTwoCells);
  for (const Eigen::Vector3d& place :
       {Eigen::Vector3d(0, 2, 2), Eigen::Vector3d(2, 2, 2), Eigen::Vector3d(-2, 2, 2),
        Eigen::Vector3d(0, 0, 2), Eigen::Vector3d(0, -2, 1.5)}) {
    EXPECT_GE(found->goodVolumeFractionAfter, share(at(place)) - 0.02) << place.transpose();
  }
}

TEST(CameraPlacement, TheSameInputGivesTheSamePlace) {
  const CameraRig rig{at({-2, -2, 2})};
  EXPECT_TRUE(placeCamera(rig, lens(), settings())->camera ==
              placeCamera(rig, lens(), settings())->camera);
}

TEST(CameraPlacement, TheFirstCameraSeesAsMuchAsItCan) {
  const auto found = placeCamera({}, lens(), settings());
  ASSERT_TRUE(found);
  RigMapper mapper;
  const RigMap map = mapper.map(gridOver(kRoom, 900), 0.5, {found->camera});
  const auto seen =
      double(std::ranges::count(map.cameraCounts, 1)) / double(map.cameraCounts.size());
  EXPECT_GT(seen, 0.7); // a corner sees three quarters or so of a box of 4 x 4 x 2 with 90 degrees
}

TEST(CameraPlacement, CanBeCanceled) {
  const auto found =
      placeCamera({}, lens(), settings(), [](CalibrationStage, double part) { return part < 0.5; });
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().code, ErrorCode::Canceled);
}

TEST(CameraPlacement, NamesWhatIsMissing) {
  PlacementSettings flat = settings();
  flat.volume.max().z() = 0.0;
  EXPECT_EQ(placeCamera({}, lens(), flat).error().field, "volume");
  EXPECT_EQ(placeCamera({}, Camera(), settings()).error().field, "lens");
}

TEST(RigMap, CellsAreNearlyCubes) {
  // 4 x 4 x 2 m in 8640 cells: 0.1547 m each, 26 x 26 x 13.
  const VolumeGrid grid = gridOver(kRoom, 8640);
  EXPECT_EQ(grid.cellsPerAxis, (std::array<int, 3>{26, 26, 13}));
  EXPECT_EQ(cellAt(grid, {-2, -2, 0}), 0U);
  EXPECT_EQ(cellAt(grid, {2, 2, 2}), grid.cellCount() - 1);
  EXPECT_FALSE(cellAt(grid, {2.1, 0, 1}));
}

TEST(RigMap, KnowsWhichCamerasChanged) {
  using Indices = std::vector<std::size_t>;
  const CameraRig before{at({-2, -2, 2}), at({2, -2, 2}), at({0, 2, 1.5})};
  EXPECT_EQ(changedCameras(before, before), Indices{});
  CameraRig now = before;
  now[0].name = "called otherwise"; // which says nothing about what it sees
  EXPECT_EQ(changedCameras(before, now), Indices{});
  now[1] = at({2, 0, 2});
  now[2].intrinsics.focalX += 1.0;
  EXPECT_EQ(changedCameras(before, now), (Indices{1, 2}));
  now = before;
  now.push_back(at({0, 0, 2}));
  EXPECT_EQ(changedCameras(before, now), Indices{3});
  now.resize(2); // what is gone has not changed
  EXPECT_EQ(changedCameras(before, now), Indices{});
}

TEST(RigMap, GoingOnGivesWhatBeginningAgainDoes) {
  CameraRig rig{at({-2, -2, 2}), at({2, -2, 2}), at({0, 2, 1.5})};
  const VolumeGrid grid = gridOver(kRoom, 500);
  RigMapper going;
  (void)going.map(grid, 0.5, rig);
  rig[1] = at({2, 0, 2});
  rig[0].name = "called otherwise";
  const RigMap moved = going.map(grid, 0.5, rig);
  EXPECT_EQ(moved.cameraCounts, RigMapper().map(grid, 0.5, rig).cameraCounts);
  rig.pop_back();
  const RigMap fewer = going.map(grid, 0.5, rig);
  const RigMap anew = RigMapper().map(grid, 0.5, rig);
  EXPECT_EQ(fewer.cameraCounts, anew.cameraCounts);
  EXPECT_EQ(fewer.cameraCount, 2U);
  for (std::size_t i = 0; i < anew.sigmas.size(); ++i) {
    if (!std::isnan(anew.sigmas[i])) {
      EXPECT_EQ(fewer.sigmas[i], anew.sigmas[i]);
    }
  }
}

TEST(RigMap, TheSummaryCountsCells) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  const RigMap map{
      {{0, 0, 0}, {4, 1, 1}, {4, 1, 1}}, 2, {0.001F, 0.004F, 0.02F, none}, {2, 3, 2, 1}};
  const RigMapSummary summary = summaryOf(map, 0.005);
  EXPECT_DOUBLE_EQ(summary.fractionWithinLimit, 0.5);
  EXPECT_DOUBLE_EQ(summary.fractionSeenByTooFew, 0.25);
  EXPECT_NEAR(summary.medianSigma, 0.02, 1e-6); // two of four are below it
}

TEST(RigMap, TheRoomIsWhatTheGridCovers) {
  ReferenceGrid grid;
  grid.origin = {-2, -2, 0};
  grid.size = {4, 3, 2};
  const CameraRig rig{at({-3, 0, 1.7}), at({0, -4, 2.5})};
  EXPECT_TRUE(roomVolume(rig, grid).max().isApprox(Eigen::Vector3d(2, 1, 2.5))); // highest camera
  EXPECT_TRUE(roomVolume({}, grid).max().isApprox(Eigen::Vector3d(2, 1, 1)));    // a quarter of 4 m
  grid.kind = GridKind::Box;
  EXPECT_TRUE(roomVolume(rig, grid).max().isApprox(Eigen::Vector3d(2, 1, 2)));
  grid.kind = GridKind::Wall; // in the plane of x and z; both cameras are on one side or in it
  grid.origin = {-2, 1, 0};
  EXPECT_TRUE(roomVolume(rig, grid).min().isApprox(Eigen::Vector3d(-2, -3, 0)));
  EXPECT_TRUE(roomVolume(rig, grid).max().isApprox(Eigen::Vector3d(2, 1, 2)));
}

TEST(CameraPlacement, AFirstPlannedCameraHangsInTheFarthestUpperCorner) {
  // Beside the camera at (-2, -2, 2) the corner across is farthest.
  const Camera planned = placedInFarthestCorner(lens(), {at({-2, -2, 2})}, kRoom);
  EXPECT_TRUE(planned.center().isApprox(Eigen::Vector3d(2, 2, 2)));
  const Eigen::Vector3d towards = (kRoom.center() - planned.center()).normalized();
  EXPECT_NEAR(planned.opticalAxis().dot(towards), 1.0, 1e-12);
  // With two in opposite corners the others are left, 4 m from both.
  const Camera third = placedInFarthestCorner(lens(), {at({-2, -2, 2}), at({2, 2, 2})}, kRoom);
  EXPECT_NEAR(third.center().x() * third.center().y(), -4.0, 1e-9);
  EXPECT_NEAR(placedInFarthestCorner(lens(), {}, kRoom).center().z(), 2.0, 1e-12);
}

TEST(CameraPlacement, FiguresAreThoseOfTheMapThatIsShown) {
  const CameraRig rig{at({-2, 0, 1.5})};
  PlacementSettings onMap = settings();
  onMap.reportedCellCount = 2000;
  const auto found = placeCamera(rig, lens(), onMap);
  const auto plain = placeCamera(rig, lens(), settings());
  ASSERT_TRUE(found && plain);
  EXPECT_EQ(found->camera, plain->camera); // what is told does not change what is found
  CameraRig with = rig;
  with.push_back(found->camera);
  const auto shared = [&](const CameraRig& cameras) {
    const RigMap map = RigMapper().map(gridOver(kRoom, 2000), onMap.pixelSigma, cameras);
    return summaryOf(map, onMap.maxGoodSigma).fractionWithinLimit;
  };
  EXPECT_EQ(found->goodVolumeFractionBefore, shared(rig));
  EXPECT_EQ(found->goodVolumeFractionAfter, shared(with));
}

} // namespace
} // namespace dewpoint::tests
