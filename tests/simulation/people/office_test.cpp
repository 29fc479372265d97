// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/people/office.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

OfficeScene oneWalker() {
  OfficeScene scene;
  simulation::Walker walker;
  walker.height = 1.8;
  walker.waypoints = {{0.0, {-1.0, 0.2}}, {2.0, {1.0, 0.2}}};
  walker.presentFrom = 0.5;
  scene.people.push_back(walker);
  return scene;
}

TEST(Office, ShowsAPersonWhereThePersonIs) {
  simulation::ViewCache views;
  const OfficeRenderer renderer(oneWalker(), views);
  const std::int64_t frame = 15; // 1 s: in the middle of the way
  EXPECT_LT((renderer.bodyCenter(0, 1.0) - Eigen::Vector3d(0.0, 0.2, 0.9)).norm(), 1e-9);
  for (std::size_t k = 0; k < 4; ++k) {
    cv::Mat who;
    const cv::Mat image = renderer.render(k, frame, &who);
    ASSERT_EQ(image.size(), cv::Size(320, 240));
    const auto pixel = Projector(renderer.scene().cameras[k]).project({0.0, 0.2, 1.2}); // the chest
    ASSERT_TRUE(pixel);
    EXPECT_EQ(who.at<unsigned char>(static_cast<int>(pixel->y()), static_cast<int>(pixel->x())), 1);
    // 1.8 m high, 0.4 m wide, 4.7 m away, at 230 px: about 88 x 20 px.
    EXPECT_GT(cv::countNonZero(who), 500);
    EXPECT_LT(cv::countNonZero(who), 2500);
  }
}

TEST(Office, IsAPureFunction) {
  simulation::ViewCache views;
  const OfficeRenderer renderer(oneWalker(), views);
  EXPECT_EQ(cv::norm(renderer.render(2, 20), renderer.render(2, 20), cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(renderer.render(2, 20), renderer.render(2, 21), cv::NORM_INF), 0.0);
}

TEST(Office, NobodyIsThereBeforeTheBeginningOrBehindTheWalls) {
  simulation::ViewCache views;
  OfficeScene scene = oneWalker();
  scene.people[0].waypoints = {{0.0, {-4.2, 0.5}}, {2.0, {-2.0, 0.5}}};
  const OfficeRenderer renderer(scene, views);
  EXPECT_FALSE(renderer.isInsideOffice(0, 0.2));  // not there yet
  EXPECT_FALSE(renderer.isInsideOffice(0, 0.55)); // behind the wall
  EXPECT_TRUE(renderer.isInsideOffice(0, 1.5));
  cv::Mat who;
  (void)renderer.render(0, 8, &who); // 0.53 s
  EXPECT_EQ(cv::countNonZero(who), 0);
  (void)renderer.render(0, 0, &who);
  EXPECT_EQ(cv::countNonZero(who), 0);
  const cv::Mat empty = renderer.backgroundImage(0);
  EXPECT_LT(cv::mean(cv::abs(empty - renderer.render(0, 0)))[0], 4.0); // the noise
}

} // namespace
} // namespace dewpoint::tests
