// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/region/ellipsoid_fit.h"
#include "core/observation/region/visual_hull.h"
#include "tests/observation/drawn_ellipsoids.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

using drawn::RegionScene;

constexpr int kVga = 2;

EllipsoidFit fitted(RegionScene& scene, const Eigen::Vector3d& center) {
  EllipsoidPrior prior;
  prior.ellipsoid = {center, 0.05 * 0.05 * Eigen::Matrix3d::Identity()};
  prior.information = Eigen::Matrix3d::Identity() / (0.1 * 0.1);
  return fitEllipsoid(scene.observation(), prior);
}

// What two or three cameras leave of an ellipsoid's surroundings is nearly symmetric about its
// center.
TEST(VisualHull, OfAnEllipsoidIsAroundItsCenter) {
  for (const int cameras : {2, 3}) {
    RegionScene scene(drawn::rigAround(cameras, kVga));
    const Ellipsoid solid = drawn::ellipsoid(drawn::kMiddle, {0.08, 0.05, 0.03}, 0.6);
    scene.show({solid});
    const EllipsoidFit fit = fitted(scene, solid.center);
    const auto hull =
        visualHull(scene.observation(), fit.views, fit.ellipsoid, Eigen::Vector3d::Zero());
    ASSERT_TRUE(hull);
    // The cameras' rays are not parallel, and the samples lie 0.29 semi-axes apart: a sixteenth of
    // the longest one. Without corners of the hull 4 / 3 pi / 0.29^3 = 172 samples would be left.
    EXPECT_LT((hull->centroid - solid.center).norm(), 5e-3) << cameras;
    EXPECT_GT(hull->samples, 150) << cameras;
  }
}

// Balls of 4 and 2 cm that touch: their volumes are as 8 to 1, so that the centroid of both lies a
// ninth of their distance of 6 cm from the center of the large one, 6.7 mm. Their discs have areas
// as 4 to 1 and a centroid at a fifth of it, 12 mm.
TEST(VisualHull, IsNearerToTheMassThanTheAreasAre) {
  RegionScene scene(drawn::rigAround(3, kVga));
  const Eigen::Vector3d apart(0.0, 0.0, 0.06);
  scene.show({drawn::ellipsoid(drawn::kMiddle, {0.04, 0.04, 0.04}),
              drawn::ellipsoid(drawn::kMiddle + apart, {0.02, 0.02, 0.02})});
  const EllipsoidFit fit = fitted(scene, drawn::kMiddle);
  ASSERT_TRUE(fit.found);
  const Eigen::Vector3d truth = drawn::kMiddle + apart / 9.0;
  const double byAreas = (fit.ellipsoid.center - truth).norm();
  const double byHull = (fit.ellipsoid.center + fit.centroidOffset - truth).norm();
  EXPECT_NEAR(byAreas, 0.0053, 0.002);
  EXPECT_LT(byHull, 0.5 * byAreas);
}

TEST(VisualHull, NeedsTwoCameras) {
  RegionScene scene(drawn::rigAround(1, kVga));
  scene.show({drawn::ellipsoid(drawn::kMiddle, {0.08, 0.05, 0.03})});
  const EllipsoidFit fit = fitted(scene, drawn::kMiddle);
  EXPECT_FALSE(visualHull(scene.observation(), fit.views, fit.ellipsoid, Eigen::Vector3d::Zero()));
}

} // namespace
} // namespace dewpoint::tests
