// SPDX-License-Identifier: GPL-3.0-or-later
// How light, shutter and a camera that drifts change what a stage shows.
#include "core/simulation/scene/stage.h"
#include "core/simulation/sensor/optics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace dewpoint::tests {
namespace {

using namespace dewpoint::simulation;

/// A small camera one meter before (0.5, 0.5, 0.35), looking along +Y: world X is to the right.
Camera stageCamera() {
  Camera camera;
  camera.name = "small";
  camera.intrinsics = {160, 120, 175.0, 175.0, 79.5, 59.5};
  camera.cameraFromWorld = lookAt({0.5, -0.5, 0.35}, {0.5, 0.5, 0.35});
  return camera;
}

std::shared_ptr<const RoomView> stageView() {
  static const auto view = std::make_shared<const RoomView>(stageCamera(), Room(Furnishing::Desk));
  return view;
}

/// A ball that passes (0.5, 0.5, 0.15) at time 0 with `speed` m/s to the right.
Stage stageWithBall(double speed) {
  Stage stage;
  stage.noiseSigma = 0.0;
  stage.views = {stageView()};
  StageBody& ball = stage.bodies.emplace_back();
  ball.path = [speed](double time) { return Eigen::Vector3d(0.5 + speed * time, 0.5, 0.15); };
  stage.sensors.emplace_back();
  return stage;
}

/// Center of mass of the pink pixels.
Eigen::Vector2d pinkCenter(const cv::Mat& image) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int count = 0;
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.cols; ++column) {
      const auto& pixel = image.at<cv::Vec3b>(row, column);
      if (pixel[2] > 1.5 * pixel[1] && pixel[0] > 1.15 * pixel[1]) {
        sum += Eigen::Vector2d(column, row);
        ++count;
      }
    }
  }
  EXPECT_GT(count, 50);
  return sum / std::max(1, count);
}

TEST(Stage, AnIdealSensorChangesNoBit) {
  Stage stage = stageWithBall(0.8);
  stage.noiseSigma = 3.0;
  const cv::Mat with = renderStage(stage, 0, 0.1, 4);
  stage.sensors.clear();
  EXPECT_EQ(cv::norm(with, renderStage(stage, 0, 0.1, 4), cv::NORM_INF), 0.0);
}

TEST(Stage, RollingShutterShowsEachRowAtItsOwnTime) {
  Stage stage = stageWithBall(1.0);
  const Eigen::Vector2d whole = pinkCenter(renderStage(stage, 0, 0.0, 0));
  stage.sensors[0].shutter.readoutSeconds = 0.03;
  const Eigen::Vector2d rolling = pinkCenter(renderStage(stage, 0, 0.0, 0));
  // 0.2 m below the axis at 1 m: row 59.5 + 35 = 94.5 of 0 to 119, 0.03 (94.5 / 119 - 0.5) =
  // 8.8 ms later than the middle, in which the ball goes 8.8 mm or 1.54 pixels.
  EXPECT_NEAR(whole.y(), 94.5, 1.5);
  EXPECT_NEAR(rolling.x() - whole.x(), 1.54, 0.3);
  EXPECT_NEAR(rolling.y(), whole.y(), 0.3);
}

TEST(Stage, AGlobalShutterRenderedInBandsIsTheSame) {
  Stage stage = stageWithBall(0.0);
  const cv::Mat whole = renderStage(stage, 0, 0.0, 0);
  stage.sensors[0].shutter.readoutSeconds = 1e-9;
  EXPECT_EQ(cv::norm(whole, renderStage(stage, 0, 0.0, 0), cv::NORM_INF), 0.0);
}

TEST(CameraDrift, BeginsAtNothingAndSettles) {
  const CameraDrift drift{{0.0, 0.0, 0.002}, 4.0};
  EXPECT_TRUE(rotationAt(drift, 0.0).isIdentity(0.0));
  // 1 - exp(-1) = 0.632 of 2 mrad about Z: sin of that at row 1, column 0.
  EXPECT_NEAR(rotationAt(drift, 4.0)(1, 0), 0.632 * 0.002, 2e-6);
  EXPECT_NEAR(rotationAt(drift, 400.0)(1, 0), 0.002, 1e-8);
}

TEST(CameraDrift, ShowsWhatTheRotatedCameraSees) {
  Stage stage = stageWithBall(0.0);
  stage.sensors[0].drift = {{0.02, -0.01, 0.03}, 1.0};
  const double late = 100.0; // settled
  const cv::Mat image = renderStage(stage, 0, late, 0);
  Camera rotated = stageCamera();
  const Eigen::Vector3d center = rotated.center();
  rotated.cameraFromWorld.linear() =
      rotated.cameraFromWorld.linear() * rotationAt(stage.sensors[0].drift, late);
  rotated.cameraFromWorld.translation() = -(rotated.cameraFromWorld.linear() * center);
  Stage other = stageWithBall(0.0);
  other.views = {std::make_shared<const RoomView>(rotated, Room(Furnishing::Desk))};
  const cv::Mat expected = renderStage(other, 0, 0.0, 0);
  // An edge pixel more or less of the 120 moves the center by 0.05 pixels.
  EXPECT_LT((pinkCenter(image) - pinkCenter(expected)).norm(), 0.3);
  // 0.03 rad at 175 pixels: 5 pixels; the border that nobody saw is left out. Fine grain that no
  // pixel resolves is not the same in two renderings, so it is blurred away.
  const cv::Mat still = renderStage(stage, 0, 0.0, 0);
  const auto apart = [&](const cv::Mat& one) {
    cv::Mat a;
    cv::Mat b;
    one.convertTo(a, CV_32F);
    expected.convertTo(b, CV_32F);
    const cv::Rect inner(20, 20, 120, 80);
    return cv::norm(blurred(a, 2.0)(inner), blurred(b, 2.0)(inner), cv::NORM_L1);
  };
  EXPECT_LT(apart(image), 0.5 * apart(still));
}

TEST(Illumination, KnowsTheSurfacesOfTheRoom) {
  const RoomView& view = *stageView();
  // Row 110: 50.5 pixels below the axis, so 0.35 m below the camera at 1.21 m: the desk.
  EXPECT_GT(surfaceNormal(view, 80, 110).z(), 0.99F);
  // The far wall, y = 2.3: it faces -Y. Row 40 is above everything on the desk.
  EXPECT_LT(surfaceNormal(view, 20, 40).y(), -0.99F);
}

TEST(Illumination, GainAndLampsAddUp) {
  const RoomView& view = *stageView();
  Illumination light;
  light.roomGain = 0.5F;
  const RelitBackground half = relightBackground(view, light);
  EXPECT_LT(cv::norm(half.ambientLight + half.directLight, 0.5 * view.background, cv::NORM_INF),
            0.01);
  light.roomGain = 1.0F;
  light.additionalLamps.push_back({{0.5F, 0.5F, 2.0F}, {0.0F, 0.0F, 0.4F}}); // red, from above
  const RelitBackground red = relightBackground(view, light);
  const cv::Vec3f before = view.background.at<cv::Vec3f>(110, 80);
  const cv::Vec3f after = cv::Mat(red.ambientLight + red.directLight).at<cv::Vec3f>(110, 80);
  EXPECT_NEAR(after[0], before[0], 0.01);
  EXPECT_GT(after[2], 1.2F * before[2]);
  // On the ball's top the light is the room's and 0.4 of red.
  const LightField field{&light, 0.0};
  const Vector3f top{0.5F, 0.5F, 0.185F};
  const Vector3f up = Vector3f::UnitZ();
  const float room = matteSurfaceLight(top, up, 1.0F);
  EXPECT_NEAR(field.lightAt(top, up).x(), room, 1e-6F);
  EXPECT_NEAR(field.lightAt(top, up).z(), room + 0.4F, 1e-5F);
}

TEST(Illumination, LampsFallOffBeyondTheirReach) {
  AdditionalLamp lamp{{0.0F, 0.0F, 1.0F}, Vector3f::Constant(0.5F)};
  EXPECT_EQ(lamp.falloffAt(50.0F), 1.0F) << "everywhere the same unless set otherwise";
  lamp.reach = 1.5F;
  EXPECT_EQ(lamp.falloffAt(0.2F), 1.0F);
  EXPECT_EQ(lamp.falloffAt(1.5F), 1.0F);
  EXPECT_FLOAT_EQ(lamp.falloffAt(3.0F), 0.25F);
  // On a floor 3 m below it; the room's own light is switched off.
  Illumination light;
  light.roomGain = 0.0F;
  light.additionalLamps = {lamp};
  const LightField field{&light, 0.0};
  EXPECT_NEAR(field.lightAt({0.0F, 0.0F, -2.0F}, Vector3f::UnitZ()).y(), 0.125F, 1e-6F);
  EXPECT_NEAR(field.lightAt({0.0F, 0.0F, 0.0F}, Vector3f::UnitZ()).y(), 0.5F, 1e-6F);
}

TEST(Illumination, AShadowTakesTheLampAndMoves) {
  const MovingShadow shadow{Vector3f::UnitX(), 0.1, 0.2, 0.1F, 0.02F, 0.8F};
  // Its middle is at x = 0.5 after two seconds, its border 0.1 m beside that.
  EXPECT_FLOAT_EQ(blockedFractionAt(shadow, {0.5F, 3.0F, 1.0F}, 2.0), 0.8F);
  EXPECT_NEAR(blockedFractionAt(shadow, {0.6F, 0.0F, 0.0F}, 2.0), 0.4F, 1e-4F);
  EXPECT_FLOAT_EQ(blockedFractionAt(shadow, {0.63F, 0.0F, 0.0F}, 2.0), 0.0F);
  EXPECT_FLOAT_EQ(blockedFractionAt(shadow, {0.5F, 0.0F, 0.0F}, 4.0), 0.0F);
  Illumination light;
  light.shadow = MovingShadow{Vector3f::UnitX(), 0.0, 0.0, 100.0F, 0.02F, 1.0F};
  const RelitBackground background = relightBackground(*stageView(), light);
  const cv::Mat dark = backgroundAt(*stageView(), background, light, 0.0);
  EXPECT_LT(cv::norm(dark, background.ambientLight, cv::NORM_INF), 1e-3) << "everything in it";
  EXPECT_GT(cv::mean(background.directLight)[1], 10.0) << "there was something to take";
}

TEST(Stage, IsMeteredInTheLightItHas) {
  Stage stage = stageWithBall(0.0);
  stage.light = [](std::size_t, double time) {
    simulation::Light light;
    light.gain.setConstant(0.5);
    light.isDark = time > 1.0;
    return light;
  };
  // Half the level is 2^-1 in the tone curve of power 0.45: 1 / 0.45 = 2.22 stops of light.
  EXPECT_NEAR(meteredBrightnessStops(stage, 0, 0.0)[1], -2.222, 1e-3);
  EXPECT_EQ(meteredBrightnessStops(stage, 0, 2.0)[1], kDarkStops);
  stage.light = nullptr;
  stage.illumination.roomGain = 2.0F;
  prepareLight(stage);
  EXPECT_NEAR(meteredBrightnessStops(stage, 0, 0.0)[2], 2.222, 1e-3);
}

TEST(Stage, PeopleWalkBehindBodies) {
  Stage stage;
  stage.noiseSigma = 0.0;
  Camera camera;
  camera.intrinsics = {80, 60, 87.5, 87.5, 39.5, 29.5};
  camera.cameraFromWorld = lookAt({0.5, -0.5, 0.35}, {0.5, 0.5, 0.35});
  stage.views = {std::make_shared<const RoomView>(camera, Room(Furnishing::Desk))};
  const cv::Mat empty = renderStage(stage, 0, 1.0, 0);
  Walker walker;
  walker.height = 1.75;
  walker.waypoints = {{0.0, {0.3, 1.75}}, {2.0, {0.7, 1.75}}};
  stage.people = {walker};
  stage.floorHeight = -0.75F;
  const cv::Mat with = renderStage(stage, 0, 1.0, 0);
  // The chest, 1.2 m above the floor, is 0.45 m above the desk: 2.25 m away, 0.1 m above the axis.
  EXPECT_GT(cv::norm(with.at<cv::Vec3b>(26, 40), empty.at<cv::Vec3b>(26, 40)), 20.0);
  StageBody& ball = stage.bodies.emplace_back();
  ball.path = [](double) { return Eigen::Vector3d(0.5, 0.5, 0.39); };
  // The ball is nearer: at row 29.5 - 87.5 x 0.04 = 26 it is what is seen.
  const cv::Vec3b pixel = renderStage(stage, 0, 1.0, 0).at<cv::Vec3b>(26, 40);
  EXPECT_GT(pixel[2], 1.5 * pixel[1]);
  EXPECT_GT(pixel[0], 1.15 * pixel[1]);
}

} // namespace
} // namespace dewpoint::tests
