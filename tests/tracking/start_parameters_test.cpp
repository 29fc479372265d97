// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/seen_volume.h"
#include "core/tracking/catalog/method_catalog.h"
#include "core/tracking/start_parameters.h"
#include "tests/observation/drawn_spheres.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace dewpoint::tests {
namespace {

ParameterValues defaultsOf(const char* method) {
  return ParameterValues(methodParameters(method));
}

ParameterValues inUse(const ParameterValues& parameters,
                      const std::optional<WorldBox>& volume = std::nullopt) {
  return effectiveParameters(parameters, drawn::rigAround(3), volume);
}

TEST(StartParameters, OfEveryMethodComeFromTheCameras) {
  const auto seen = seenVolume(drawn::rigAround(3));
  ASSERT_TRUE(seen.has_value());
  for (const char* method : {"dewpoint", "barrera", "dynamics"}) {
    const StartVolume start = startVolumeOf(inUse(defaultsOf(method)));
    // In steps of a centimeter; a half size is never too small by more than the center was moved.
    EXPECT_LT((start.center - seen->center()).cwiseAbs().maxCoeff(), 0.0051) << method;
    EXPECT_LT((start.halfSize - seen->halfSize()).maxCoeff(), 0.0101) << method;
    EXPECT_GE((start.halfSize - seen->halfSize()).minCoeff(), 0.0) << method;
    EXPECT_FALSE(inUse(defaultsOf(method)).isGiven("start_half_z")) << method;
  }
  const double size = inUse(defaultsOf("dewpoint")).at("search_size");
  EXPECT_GE(size, 2.0 * seen->halfSize().maxCoeff());
  EXPECT_LT(size, 2.0 * seen->halfSize().maxCoeff() + 0.11);
  EXPECT_EQ(size, std::round(10.0 * size) / 10.0);
}

TEST(StartParameters, AreTheDefaultsWithoutAnyCamera) {
  const ParameterValues used = effectiveParameters(defaultsOf("dewpoint"), {}, std::nullopt);
  EXPECT_EQ(used, defaultsOf("dewpoint"));
}

// A file that says where to start means the defaults by what it leaves out, as it always did.
TEST(StartParameters, HoldAsTheyAreGiven) {
  ParameterValues given = defaultsOf("dewpoint");
  ASSERT_TRUE(given.set("start_x", 0.5)); // its default, but given
  EXPECT_EQ(inUse(given), given);
  EXPECT_EQ(inUse(given).at("search_size"), 4.0);
  ParameterValues size = defaultsOf("dewpoint");
  ASSERT_TRUE(size.set("search_size", 7.0));
  EXPECT_EQ(inUse(size).at("search_size"), 7.0);
  EXPECT_EQ(startVolumeOf(inUse(size)).center, startVolumeOf(inUse(defaultsOf("dewpoint"))).center);
  ParameterValues all = defaultsOf("barrera");
  EXPECT_FALSE(all.isGiven("start_x"));
  EXPECT_TRUE(all.isGiven("particles")); // does not come from the cameras
  all.markAllAsGiven();
  EXPECT_TRUE(all.isGiven("start_x"));
  EXPECT_FALSE(all == defaultsOf("barrera"));
  EXPECT_EQ(inUse(all), all);
}

// What was suggested before does not stay: other cameras, other values.
TEST(StartParameters, FollowOtherCameras) {
  CameraRig moved = drawn::rigAround(3);
  for (Camera& camera : moved) {
    camera.cameraFromWorld.translate(Eigen::Vector3d(-2.0, 0.0, 0.0)); // of the world: +2 m
  }
  const ParameterValues before = inUse(defaultsOf("barrera"));
  const ParameterValues after = effectiveParameters(before, moved, std::nullopt);
  EXPECT_NEAR(after.at("start_x"), before.at("start_x") + 2.0, 0.0101);
  EXPECT_NEAR(after.at("start_y"), before.at("start_y"), 0.0101);
}

TEST(StartParameters, KeepToTheRangesOfTheirDeclarations) {
  CameraRig far = drawn::rigAround(2);
  for (Camera& camera : far) {
    camera.cameraFromWorld.translation() *= 1000.0; // as a rig in millimeters
  }
  const ParameterValues used = effectiveParameters(defaultsOf("dewpoint"), far, std::nullopt);
  for (const ParameterDeclaration& declaration : used.declarations()) {
    EXPECT_GE(used.at(declaration.key), declaration.minimum) << declaration.key;
    EXPECT_LE(used.at(declaration.key), declaration.maximum) << declaration.key;
  }
}

TEST(StartParameters, LieInTheVolumeOfInterest) {
  const WorldBox volume{drawn::kMiddle - Eigen::Vector3d(0.1, 0.2, 0.1),
                        drawn::kMiddle + Eigen::Vector3d(0.1, 0.2, 0.1)};
  const ParameterValues used = inUse(defaultsOf("dewpoint"), volume);
  EXPECT_LT((startVolumeOf(used).center - drawn::kMiddle).norm(), 0.01);
  EXPECT_NEAR(used.at("start_half_y"), 0.2, 0.0101);
  EXPECT_NEAR(used.at("search_size"), 0.4, 0.101);
  // Out of sight of all cameras.
  const WorldBox elsewhere{{20.0, 20.0, 0.0}, {22.0, 21.0, 1.0}};
  EXPECT_EQ(startVolumeOf(inUse(defaultsOf("barrera"), elsewhere)).center,
            Eigen::Vector3d(21.0, 20.5, 0.5));
}

TEST(StartVolume, WithinABoxIsWhatBothHaveInCommon) {
  const WorldBox box{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
  const StartVolume half = startVolumeWithin({{1.0, 0.5, 0.5}, {0.5, 0.25, 5.0}}, box);
  EXPECT_EQ(half.center, Eigen::Vector3d(0.75, 0.5, 0.5));
  EXPECT_EQ(half.halfSize, Eigen::Vector3d(0.25, 0.25, 0.5));
  const StartVolume point = startVolumeWithin({{0.25, 0.5, 0.75}, Eigen::Vector3d::Zero()}, box);
  EXPECT_EQ(point.center, Eigen::Vector3d(0.25, 0.5, 0.75));
  EXPECT_EQ(point.halfSize, Eigen::Vector3d(0.0, 0.0, 0.0));
  const StartVolume apart = startVolumeWithin({{3.0, 0.5, 0.5}, {0.5, 0.5, 0.5}}, box);
  EXPECT_EQ(apart.center, box.center());
  EXPECT_EQ(apart.halfSize, box.halfSize());
}

// Another method has defaults of its own; what was given stays given.
TEST(CarriedOver, DefaultsThatWereGivenDoNotComeFromTheCameras) {
  EXPECT_FALSE(carryOverParameters(defaultsOf("dewpoint"), "barrera").isGiven("start_x"));
  EXPECT_FALSE(carryOverParameters(inUse(defaultsOf("dewpoint")), "barrera").isGiven("start_x"));
  ParameterValues given = defaultsOf("dewpoint");
  given.markAllAsGiven();
  ASSERT_TRUE(given.set("start_z", 0.3));
  const ParameterValues carried = carryOverParameters(given, "barrera");
  EXPECT_EQ(carried.at("start_x"), 0.4);
  EXPECT_EQ(carried.at("start_z"), 0.3);
  EXPECT_TRUE(carried.isGiven("start_x"));
  EXPECT_EQ(carryOverParameters(given, "histogram"), defaultsOf("histogram"));
}

} // namespace
} // namespace dewpoint::tests
