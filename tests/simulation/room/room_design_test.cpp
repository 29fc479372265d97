// SPDX-License-Identifier: GPL-3.0-or-later
// Rooms of another design, and people on a stage.
#include "core/simulation/scene/stage.h"

#include <gtest/gtest.h>

#include <memory>

namespace dewpoint::tests {
namespace {

using namespace dewpoint::simulation;

/// 80 x 60 pixels, one meter before the middle of the desk, looking along +Y.
std::shared_ptr<const RoomView> viewOf(const Room& room) {
  Camera camera;
  camera.intrinsics = {80, 60, 87.5, 87.5, 39.5, 29.5};
  camera.cameraFromWorld = lookAt({0.5, -0.5, 0.35}, {0.5, 0.5, 0.35});
  return std::make_shared<const RoomView>(camera, room);
}

TEST(RoomDesign, AddsFurnitureWallsAndALamp) {
  RoomDesign design;
  design.further.add(Shape::Box, {0.5F, 0.5F, 0.35F}, {0.1F, 0.1F, 0.1F},
                     {Pattern::Plain, rgb(250, 10, 10)});
  design.walls = Material{Pattern::Plain, rgb(10, 10, 250)};
  design.lamp = Vector3f{0.5F, -1.0F, 1.5F};
  const Room room(Furnishing::Desk, design);
  EXPECT_EQ(room.lamp(), *design.lamp);
  EXPECT_EQ(Room(Furnishing::Desk).lamp(), kLampPosition);
  // From the camera to the front of the box: 1 m less its half size.
  EXPECT_NEAR(room.cast({0.5F, -0.5F, 0.35F}, Vector3f::UnitY()).distance, 0.9F, 1e-5F);
  const auto view = viewOf(room);
  const auto& box = view->background.at<cv::Vec3f>(30, 40);
  EXPECT_GT(box[2], 5.0F * box[0]) << "red";
  const auto& wall = view->background.at<cv::Vec3f>(10, 5);
  EXPECT_GT(wall[0], 5.0F * wall[2]) << "blue";
}

TEST(Stage, PeopleWalkBehindBodies) {
  Stage stage;
  stage.noiseSigma = 0.0;
  stage.views = {viewOf(Room(Furnishing::Desk))};
  const cv::Mat empty = renderStage(stage, 0, 1.0, 0);
  Walker walker;
  walker.height = 1.75;
  walker.way = {{0.0, {0.3, 1.75}}, {2.0, {0.7, 1.75}}};
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
