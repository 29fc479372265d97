// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/dewpoint/track/region_track.h"
#include "tests/observation/drawn_ellipsoids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dewpoint::tests {
namespace {

using drawn::kFrame;
using drawn::kVga;
using drawn::RegionScene;

BernoulliTrackSettings settings(double direction = 0.0) {
  BernoulliTrackSettings settings;
  settings.accelerationSigma = 8.0;
  settings.systematicErrors.directionSigma = direction;
  return settings;
}

/// A track that has seen a solid at rest for some frames.
RegionTrack trackOf(RegionScene& scene, const Ellipsoid& solid, int frames,
                    double direction = 0.0) {
  RegionTrack track{Target{}};
  track.configure(settings(direction));
  track.restart({drawn::kMiddle, Eigen::Vector3d::Constant(0.3)});
  scene.show({solid});
  ThreadTeam team;
  for (int frame = 0; frame < frames; ++frame) {
    const RandomKey key{1, static_cast<std::uint32_t>(frame), 0};
    track.predict(kFrame, key);
    track.update(scene.observation(), {}, key, team);
  }
  return track;
}

const Ellipsoid kSolid = drawn::ellipsoid(drawn::kMiddle, {0.08, 0.04, 0.04}, 0.5);

TEST(RegionTrack, FindsWhatIsThere) {
  RegionScene scene(drawn::rigAround(2, kVga));
  const RegionTrack track = trackOf(scene, kSolid, 1);
  ASSERT_NE(track.hypothesis(), nullptr);
  EXPECT_GT(track.hypothesis()->probability, 0.5);
  EXPECT_LT((track.hypothesis()->position() - kSolid.center).norm(), 0.005);
  EXPECT_NEAR(track.longestAxis(), 0.08, 0.015);
}

// Not found again where another target is.
TEST(RegionTrack, KeepsOutOfWhatIsOccupied) {
  RegionScene scene(drawn::rigAround(2, kVga));
  scene.show({kSolid});
  RegionTrack track{Target{}};
  track.configure(settings());
  track.restart({drawn::kMiddle, Eigen::Vector3d::Constant(0.3)});
  ThreadTeam team;
  track.update(scene.observation(), {{kSolid.center, 0.05}}, {1, 0, 0}, team);
  EXPECT_EQ(track.hypothesis(), nullptr);
}

// A second update on one frame starts from the prediction: it counts the images once.
TEST(RegionTrack, ASecondUpdateCountsNothingTwice) {
  RegionScene scene(drawn::rigAround(2, kVga));
  RegionTrack track = trackOf(scene, kSolid, 3);
  const auto once = track.hypothesis()->gaussian.covariance;
  ThreadTeam team;
  track.update(scene.observation(), {}, {1, 2, 1}, team);
  EXPECT_LT((track.hypothesis()->gaussian.covariance - once).norm(), 1e-12);
}

// Half a degree of each camera's direction is 9 mm a meter away, and at least 0.15 of the standard
// deviation of its image's area, half its semi-axes, is stated for its shape: 3 to 6 mm.
TEST(RegionTrack, StatesWhatNoFrameAveragesAway) {
  RegionScene scene(drawn::rigAround(2, kVga));
  const double direction = 0.5 * std::numbers::pi / 180.0;
  RegionTrack track = trackOf(scene, kSolid, 30, direction);
  const SphereEstimate estimate = track.estimate(scene.observation());
  EXPECT_TRUE(estimate.isValid);
  const double sigma = std::sqrt(estimate.covariance.trace() / 3.0);
  EXPECT_GT(sigma, 0.006);
  EXPECT_LT(sigma, 0.02);
  EXPECT_NEAR(estimate.radius, kSolid.radius(), 0.15 * kSolid.radius());
}

TEST(RegionTrack, APositionByHandBeginsThere) {
  RegionScene scene(drawn::rigAround(2, kVga));
  scene.show({kSolid});
  RegionTrack track{Target{}};
  track.configure(settings());
  track.restart({drawn::kMiddle, Eigen::Vector3d::Constant(0.3)});
  ThreadTeam team;
  track.startAt(
      {kSolid.center + Eigen::Vector3d(0.01, 0.0, 0.01), 0.02 * 0.02 * Eigen::Matrix3d::Identity()},
      0.04 * 0.04 * Eigen::Matrix3d::Identity(), true, scene.observation(), {1, 0, 0}, team);
  ASSERT_NE(track.hypothesis(), nullptr);
  EXPECT_TRUE(track.hypothesis()->givenCovariance);
  EXPECT_LT((track.hypothesis()->position() - kSolid.center).norm(), 0.005);
}

} // namespace
} // namespace dewpoint::tests
