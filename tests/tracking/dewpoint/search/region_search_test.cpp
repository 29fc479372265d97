// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/search/region_search.h"
#include "tests/observation/drawn_ellipsoids.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

using drawn::kVga;
using drawn::RegionScene;

TEST(RegionSearch, FindsTheLargestThingFirst) {
  RegionScene scene(drawn::rigAround(3, kVga));
  const Ellipsoid large = drawn::ellipsoid(drawn::kMiddle, {0.08, 0.04, 0.03}, 0.5);
  const Ellipsoid small =
      drawn::ellipsoid(drawn::kMiddle + Eigen::Vector3d(0.2, 0.05, 0.05), {0.015, 0.01, 0.01});
  scene.show({large, small});
  const auto found = findRegionCandidates(scene.observation(), 0.0, std::nullopt, 4);
  ASSERT_GE(found.size(), 2U);
  EXPECT_LT((found[0].center - large.center).norm(), 0.005);
  EXPECT_NEAR(found[0].radius, large.radius(), 0.3 * large.radius());
  EXPECT_LT((found[1].center - small.center).norm(), 0.005);
}

TEST(RegionSearch, KeepsToBoundsAndToASizeThatIsKnown) {
  RegionScene scene(drawn::rigAround(2, kVga));
  const Ellipsoid solid = drawn::ellipsoid(drawn::kMiddle, {0.08, 0.04, 0.03}, 0.5);
  scene.show({solid});
  const WorldBox elsewhere{drawn::kMiddle + Eigen::Vector3d::Constant(0.2),
                           drawn::kMiddle + Eigen::Vector3d::Constant(0.5)};
  EXPECT_TRUE(findRegionCandidates(scene.observation(), 0.0, elsewhere, 4).empty());
  EXPECT_TRUE(findRegionCandidates(scene.observation(), 0.005, std::nullopt, 4).empty());
  EXPECT_FALSE(findRegionCandidates(scene.observation(), 0.05, std::nullopt, 4).empty());
}

TEST(RegionSearch, NeedsTwoCameras) {
  RegionScene scene(drawn::rigAround(1, kVga));
  scene.show({drawn::ellipsoid(drawn::kMiddle, {0.08, 0.04, 0.03})});
  EXPECT_TRUE(findRegionCandidates(scene.observation(), 0.0, std::nullopt, 4).empty());
}

} // namespace
} // namespace dewpoint::tests
