// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/rotation_vector.h"
#include "core/geometry/similarity.h"
#include "tests/geometry/webcam.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

Similarity someChange() {
  return {1.5, geometry::rotationFromVector({0.3, -0.2, 0.9}), {0.4, -1.0, 2.0}};
}

TEST(Similarity, OneAfterTheOtherIsTheirProduct) {
  const Similarity second{0.5, geometry::rotationFromVector({-1.0, 0.1, 0.2}), {3.0, 0.0, 1.0}};
  const Eigen::Vector3d point(0.7, -0.3, 1.1);
  EXPECT_LT(((second * someChange()) * point - second * (someChange() * point)).norm(), 1e-14);
}

TEST(Similarity, ACameraSeesAMovedPointWhereItSawIt) {
  const Camera before = webcam();
  const Camera after = transformed(someChange(), before);
  EXPECT_LT((after.center() - someChange() * before.center()).norm(), 1e-14);
  for (const Eigen::Vector3d& inCamera :
       {Eigen::Vector3d(0.1, -0.2, 1.0), Eigen::Vector3d(-0.4, 0.3, 3.0)}) {
    const Eigen::Vector3d point = before.cameraFromWorld.inverse() * inCamera;
    const Eigen::Vector3d seen = after.cameraFromWorld * (someChange() * point);
    EXPECT_LT((seen.normalized() - inCamera.normalized()).norm(), 1e-14);
    EXPECT_NEAR(seen.norm(), 1.5 * inCamera.norm(), 1e-13); // farther away by the scale
  }
}

TEST(Similarity, IsFoundFromThePointsItMoved) {
  const std::vector<Eigen::Vector3d> from{
      {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, {0.0, 0.0, 3.0}};
  std::vector<Eigen::Vector3d> to;
  for (const Eigen::Vector3d& point : from) {
    to.push_back(someChange() * point);
  }
  const Similarity found = fitSimilarity(from, to, true);
  EXPECT_NEAR(found.scale, 1.5, 1e-13);
  EXPECT_LT((found.rotation - someChange().rotation).norm(), 1e-13);
  EXPECT_LT((found.translation - someChange().translation).norm(), 1e-13);
  EXPECT_EQ(fitSimilarity(from, to, false).scale, 1.0);
}

} // namespace
} // namespace dewpoint::tests
