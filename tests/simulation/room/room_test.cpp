// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/room/room.h"
#include "core/simulation/room/view_cache.h"

#include <gtest/gtest.h>

#include <memory>

namespace dewpoint::tests {
namespace {

using namespace dewpoint::simulation;

/// 80 x 60 pixels, one meter before the middle of the desk, looking along +Y.
Camera cameraAtDesk() {
  Camera camera;
  camera.intrinsics = {80, 60, 87.5, 87.5, 39.5, 29.5};
  camera.cameraFromWorld = lookAt({0.5, -0.5, 0.35}, {0.5, 0.5, 0.35});
  return camera;
}

TEST(Room, ADeskIsAtHeightZeroAndAHallHasWalls) {
  const RoomHit desk = Room(Furnishing::Desk).castRay({0.5F, 0.5F, 0.4F}, {0.0F, 0.0F, -1.0F});
  EXPECT_NEAR(desk.distance, 0.4F, 1e-5F);
  EXPECT_LT((desk.normal - Vector3f::UnitZ()).norm(), 1e-5F);
  const Room hall(Furnishing::Hall);
  const RoomHit wall = hall.castRay({0.0F, 0.0F, 2.2F}, {1.0F, 0.0F, 0.0F});
  EXPECT_NEAR(wall.distance, kHallHalfSize, 1e-4F);
  EXPECT_LT((wall.normal + Vector3f::UnitX()).norm(), 1e-5F) << "walls face inward";
}

TEST(Room, WhatFacesTheLampIsBrighter) {
  const Vector3f point{0.5F, 0.5F, 0.0F};
  const Vector3f towards = (kLampPosition - point).normalized();
  EXPECT_GT(matteSurfaceLight(point, towards, 1.0F), matteSurfaceLight(point, -towards, 1.0F));
  EXPECT_GT(matteSurfaceLight(point, towards, 1.0F), matteSurfaceLight(point, towards, 0.0F))
      << "a shadow";
}

TEST(RoomDesign, AddsFurnitureWallsAndALamp) {
  RoomDesign design;
  design.additionalFurniture.add(Shape::Box, {0.5F, 0.5F, 0.35F}, {0.1F, 0.1F, 0.1F},
                                 {Pattern::Plain, rgb(250, 10, 10)});
  design.wallMaterial = Material{Pattern::Plain, rgb(10, 10, 250)};
  design.lampPosition = Vector3f{0.5F, -1.0F, 1.5F};
  const Room room(Furnishing::Desk, design);
  EXPECT_EQ(room.lampPosition(), *design.lampPosition);
  EXPECT_EQ(Room(Furnishing::Desk).lampPosition(), kLampPosition);
  // From the camera to the front of the box: 1 m less its half size.
  EXPECT_NEAR(room.castRay({0.5F, -0.5F, 0.35F}, Vector3f::UnitY()).distance, 0.9F, 1e-5F);
  const RoomView view(cameraAtDesk(), room);
  const auto& box = view.background.at<cv::Vec3f>(30, 40);
  EXPECT_GT(box[2], 5.0F * box[0]) << "red";
  const auto& wall = view.background.at<cv::Vec3f>(10, 5);
  EXPECT_GT(wall[0], 5.0F * wall[2]) << "blue";
}

TEST(ViewCache, RendersEachViewOnce) {
  ViewCache cache;
  const auto first = cache.view(cameraAtDesk(), Furnishing::Desk);
  EXPECT_EQ(cache.view(cameraAtDesk(), Furnishing::Desk), first);
  EXPECT_NE(cache.view(cameraAtDesk(), Furnishing::Hall), first);
  Camera moved = cameraAtDesk();
  moved.cameraFromWorld = lookAt({0.5, -0.6, 0.35}, {0.5, 0.5, 0.35});
  EXPECT_NE(cache.view(moved, Furnishing::Desk), first);
}

} // namespace
} // namespace dewpoint::tests
