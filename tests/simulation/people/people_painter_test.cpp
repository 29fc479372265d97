// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/people/office.h"
#include "core/simulation/people/people_painter.h"

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <cstdlib>

namespace dewpoint::tests {
namespace {

using simulation::Posture;
using simulation::Walker;

constexpr double kFocal = 230.0; ///< px
constexpr double kEye = 0.9;     ///< height of the camera, meters
constexpr double kNearY = -3.3;  ///< the camera's y: it looks along y, horizontally

simulation::ViewCache& views() {
  static simulation::ViewCache cache; // one view for all tests of this file
  return cache;
}

/// One camera at x = 0 in the empty middle of the office.
OfficeScene sceneOf(const std::vector<Walker>& people) {
  Camera camera;
  camera.name = "camera 1";
  camera.intrinsics = {160, 240, kFocal, kFocal, 79.5, 119.5};
  camera.cameraFromWorld = lookAt({0.0, kNearY, kEye}, {0.0, 3.0, kEye});
  OfficeScene scene;
  scene.cameras = {camera};
  scene.people = people;
  return scene;
}

/// Stands at a point of the floor and faces x, so that the camera sees a side.
Walker standing(double height, double x, double y) {
  Walker walker;
  walker.height = height;
  walker.waypoints = {{0.0, {x, y}}};
  return walker;
}

cv::Mat whoIn(const OfficeRenderer& renderer, std::int64_t frame = 0) {
  cv::Mat who;
  (void)renderer.render(0, frame, &who);
  return who;
}

/// Rows from the highest to the lowest pixel of the first person.
int rowsOf(const Walker& walker, std::int64_t frame = 0) {
  const OfficeRenderer renderer(sceneOf({walker}), views());
  return cv::boundingRect(whoIn(renderer, frame) == 1).height;
}

/// Rows that something of `height` meters has at y = 1, 4.3 m away.
double rowsFor(double height) {
  return kFocal * height / (1.0 - kNearY);
}

// From the floor to the top of the hair, 1.755 / 1.75 of the height: 59 px and 94 px.
TEST(PeoplePainter, ShowsAChildAsHighAsAChildIs) {
  EXPECT_NEAR(rowsOf(standing(1.10, 0.0, 1.0)), rowsFor(1.10 * 1.755 / 1.75), 2.0);
  EXPECT_NEAR(rowsOf(standing(1.75, 0.0, 1.0)), rowsFor(1.755), 2.0);
  EXPECT_NEAR(rowsOf(standing(0.90, 0.0, 1.0)), rowsFor(0.90 * 1.755 / 1.75), 2.0);
  EXPECT_NEAR(rowsOf(standing(2.00, 0.0, 1.0)), rowsFor(2.00 * 1.755 / 1.75), 2.0);
}

// The top is 1.346 m high then (see the test of Walker): 72 px instead of 94.
TEST(PeoplePainter, ShowsWhoSitsLower) {
  Walker walker = standing(1.75, 0.0, 1.0);
  walker.postures = {{1.0, Posture::Sitting}};
  EXPECT_NEAR(rowsOf(walker, 0), rowsFor(1.755), 2.0);
  EXPECT_NEAR(rowsOf(walker, 60), rowsFor(1.346), 2.0); // 4 s
  const OfficeRenderer renderer(sceneOf({walker}), views());
  EXPECT_NEAR(renderer.bodyCenter(0, 4.0).z(), 0.671, 0.001); // half of 1.342 m
}

// The first stands a meter behind the second and 0.15 m, 8 px, aside. Their trunks are 13 and 17 px
// wide, so that both are seen and the second hides a part of the first.
TEST(PeoplePainter, MasksDoNotOverlapAndTheNearerOneWins) {
  const OfficeRenderer renderer(sceneOf({standing(1.75, 0.15, 1.0), standing(1.75, 0.0, 0.0)}),
                                views());
  const cv::Mat who = whoIn(renderer);
  const cv::Mat far = renderer.silhouette(0, 0, 0);
  const cv::Mat near = renderer.silhouette(0, 0, 1);
  const cv::Mat both = far & near;
  EXPECT_GT(cv::countNonZero(both), 50);
  EXPECT_EQ(cv::countNonZero(both & (who != 2)), 0);
  EXPECT_GT(cv::countNonZero(who == 1), 100);
  EXPECT_EQ(cv::countNonZero((who == 1) & near), 0);
  // What is visible of somebody is a part of the whole.
  EXPECT_EQ(cv::countNonZero((who == 1) & ~far), 0);
  EXPECT_EQ(cv::countNonZero((who == 2) & ~near), 0);
}

// A box of 0.4 x 0.3 m, 4 m away, is 23 x 17 px; it hides the chest, and is no body itself.
TEST(PeoplePainter, ALoadHidesABodyAndIsNone) {
  Walker walker = standing(1.75, 0.0, 1.0);
  walker.waypoints = {{0.0, {0.0, 1.0}},
                      {1000.0, {0.0, 0.9}}}; // stands, as good as, and faces the camera
  walker.carriedObject = simulation::CarriedObject();
  const OfficeRenderer renderer(sceneOf({walker}), views());
  const cv::Mat who = whoIn(renderer);
  const cv::Mat whole = renderer.silhouette(0, 0, 0);
  EXPECT_GT(cv::countNonZero(whole) - cv::countNonZero(who == 1), 200);
  const auto pixel = Projector(renderer.scene().cameras[0]).project({0.0, 0.7, 1.10});
  ASSERT_TRUE(pixel);
  const cv::Point chest(static_cast<int>(std::lround(pixel->x())),
                        static_cast<int>(std::lround(pixel->y())));
  EXPECT_EQ(who.at<unsigned char>(chest), 0);
  EXPECT_EQ(whole.at<unsigned char>(chest), 255);
}

TEST(PeoplePainter, NobodyHasASilhouetteWhileNotThere) {
  Walker walker = standing(1.75, 0.0, 1.0);
  walker.presentFrom = 1.0;
  const OfficeRenderer renderer(sceneOf({walker}), views());
  EXPECT_EQ(cv::countNonZero(renderer.silhouette(0, 0, 0)), 0);
  EXPECT_GT(cv::countNonZero(renderer.silhouette(0, 15, 0)), 500);
}

// A cabinet 0.5 m wide and 0.9 m high, 3.8 m away, is 30 x 54 px.
TEST(PeoplePainter, MovedFurnitureIsWhereItIsAtTheTime) {
  OfficeScene scene = sceneOf({});
  scene.noiseSigma = 0.0;
  const OfficeRenderer bare(scene, views());
  auto cabinet = simulation::makeCabinet({0.25F, 0.2F, 0.45F}, simulation::rgb(200, 40, 40));
  cabinet.waypoints = {{1.0, {-0.6, 0.5}, 0.0}, {2.0, {0.6, 0.5}, 0.0}};
  scene.furniture = {cabinet};
  const OfficeRenderer renderer(scene, views());
  EXPECT_LT((renderer.scene().furniture[0].poseAt(1.5).position - Eigen::Vector2d(0.0, 0.5)).norm(),
            1e-12);
  const cv::Mat left = renderer.backgroundImage(0);
  const cv::Mat right = renderer.render(0, 60);
  const Projector projector(scene.cameras[0]);
  for (const double x : {-0.6, 0.6}) {
    const auto pixel = projector.project({x, 0.3, 0.45});
    ASSERT_TRUE(pixel);
    const cv::Point at(static_cast<int>(pixel->x()), static_cast<int>(pixel->y()));
    const cv::Mat& shown = x < 0.0 ? left : right;
    const cv::Mat& other = x < 0.0 ? right : left;
    const auto red = [&](const cv::Mat& image) {
      const auto color = image.at<cv::Vec3b>(at);
      return static_cast<int>(color[2]) - static_cast<int>(color[0]);
    };
    EXPECT_GT(red(shown), 40);
    EXPECT_LT(std::abs(red(other) - red(bare.backgroundImage(0))), 20);
  }
  EXPECT_EQ(cv::countNonZero(whoIn(renderer)), 0); // furniture is nobody
}

} // namespace
} // namespace dewpoint::tests
