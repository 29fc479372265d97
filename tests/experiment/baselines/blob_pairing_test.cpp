// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/baselines/blob_pairing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewpoint::tests {
namespace {

constexpr double kTargetRadius = 0.05; // of the target, meters

/// Focal length 1000 px, 1 m from the origin: 1 mm there is 1 px.
Camera millimeterCamera(const Eigen::Vector3d& position) {
  Camera camera;
  camera.intrinsics = {1001, 1001, 1000.0, 1000.0, 500.0, 500.0};
  camera.cameraFromWorld = lookAt(position, {0, 0, 0});
  return camera;
}

CameraRig threeCameras() {
  return {millimeterCamera({1, 0, 0}), millimeterCamera({0, 1, 0}),
          millimeterCamera({-0.6, -0.8, 0})};
}

/// The blob of a ball, moved by some pixels, and with its size times a factor.
Blob blobOf(const Camera& camera, const Eigen::Vector3d& ball, double factor = 1.0,
            const Eigen::Vector2d& moved = Eigen::Vector2d::Zero()) {
  const double radiusPx = factor * SphereProjector(camera).project(ball, kTargetRadius)->radius;
  Blob blob;
  blob.center = *Projector(camera).project(ball) + moved;
  blob.areaPx = static_cast<int>(std::lround(std::numbers::pi * radiusPx * radiusPx));
  return blob;
}

/// Every ball in every camera.
std::vector<CameraBlobs> seen(const CameraRig& rig, const std::vector<Eigen::Vector3d>& balls) {
  std::vector<CameraBlobs> cameras;
  for (const Camera& camera : rig) {
    CameraBlobs& shown = cameras.emplace_back();
    shown.hasImage = true;
    for (const Eigen::Vector3d& ball : balls) {
      shown.blobs.push_back(blobOf(camera, ball));
    }
  }
  return cameras;
}

CameraRig twoOfThreeCameras() {
  CameraRig rig = threeCameras();
  rig.pop_back();
  return rig;
}

TEST(BlobPairing, PairsBlobsWhoseRaysMeet) {
  // One ball 100 mm above the other: rays of different balls miss each other by about 100 px, 50
  // from the point between them; 25 are allowed for a radius of 50 px.
  const CameraRig rig = twoOfThreeCameras();
  const Eigen::Vector3d low(0.05, 0.02, -0.05);
  const Eigen::Vector3d high(-0.03, 0.04, 0.05);
  const auto pairs = BlobPairing(rig).pairBlobs(seen(rig, {low, high}), kTargetRadius, 1);
  ASSERT_EQ(pairs.size(), 2U);
  EXPECT_LT((pairs[0].point.position - low).norm(), 1e-9);
  EXPECT_LT((pairs[1].point.position - high).norm(), 1e-9);
  EXPECT_NEAR(pairs[0].cost, 0.0, 1e-3) << "only the area is rounded to whole pixels";
}

TEST(BlobPairing, JoinsFurtherCamerasAndMissesThoseThatShouldSeeIt) {
  const CameraRig rig = threeCameras();
  const Eigen::Vector3d ball(0.01, 0.02, 0.03);
  auto cameras = seen(rig, {ball});
  const auto cheapest = [&] {
    const auto pairs = BlobPairing(rig).pairBlobs(cameras, kTargetRadius, 1);
    return *std::ranges::min_element(pairs, {}, &PairedBlobs::cost);
  };
  EXPECT_EQ(cheapest().point.bearings.size(), 3U);
  EXPECT_NEAR(cheapest().cost, 0.0, 1e-3);
  cameras[2].blobs.clear();
  EXPECT_EQ(cheapest().point.bearings.size(), 2U);
  EXPECT_NEAR(cheapest().cost, kMissingCost, 1e-3);
  cameras[2].hasImage = false;
  EXPECT_NEAR(cheapest().cost, 0.0, 1e-3) << "it cannot show anything";
}

TEST(BlobPairing, TheKnownSizeCountsInEachCamera) {
  // 1.5 times too large in both: 2 (ln 1.5 / 0.2)² = 8.220; 2.2 times: refused.
  const CameraRig rig = twoOfThreeCameras();
  const auto pairsAt = [&](double factor) {
    std::vector<CameraBlobs> cameras;
    for (const Camera& camera : rig) {
      cameras.push_back({true, {blobOf(camera, {0, 0, 0}, factor)}});
    }
    return BlobPairing(rig).pairBlobs(cameras, kTargetRadius, 1);
  };
  ASSERT_EQ(pairsAt(1.5).size(), 1U);
  EXPECT_NEAR(pairsAt(1.5).front().cost, 8.220, 0.01);
  ASSERT_EQ(pairsAt(1.0 / 1.5).size(), 1U);
  EXPECT_NEAR(pairsAt(1.0 / 1.5).front().cost, 8.220, 0.02);
  EXPECT_TRUE(pairsAt(2.2).empty());
  EXPECT_TRUE(pairsAt(0.45).empty());
}

TEST(BlobPairing, AnUnknownSizeMustBeTheSameInAllCameras) {
  // 1.5 times larger in one than in the other: each is ln 1.5 / 2 from the mean, together
  // 2 (0.2027 / 0.2)² = 2.055. 4.5 times: each is off by more than 2.
  const CameraRig rig = twoOfThreeCameras();
  const auto pairsAt = [&](double factor) {
    return BlobPairing(rig).pairBlobs(
        {{true, {blobOf(rig[0], {0, 0, 0}, factor)}}, {true, {blobOf(rig[1], {0, 0, 0})}}}, 0.0, 1);
  };
  EXPECT_NEAR(pairsAt(1.0).front().cost, 0.0, 1e-3);
  EXPECT_NEAR(pairsAt(1.5).front().cost, 2.055, 0.01);
  EXPECT_TRUE(pairsAt(4.5).empty());
}

TEST(BlobPairing, LargeBlobsMayMissEachOtherByMore) {
  // At the origin 50 mm look 50 px large: 25 px are allowed. 40 px of height between the two
  // cameras are 20 for each: 0.8 of what is allowed, 4 * 0.8² = 2.56. A blob of 2 px: 4 px allowed.
  const CameraRig rig = twoOfThreeCameras();
  const auto pairsAt = [&](double height, double factor) {
    return BlobPairing(rig).pairBlobs({{true, {blobOf(rig[0], {0, 0, 0}, factor, {0.0, height})}},
                                       {true, {blobOf(rig[1], {0, 0, 0}, factor)}}},
                                      0.0, 1);
  };
  ASSERT_EQ(pairsAt(40.0, 1.0).size(), 1U);
  EXPECT_NEAR(pairsAt(40.0, 1.0).front().cost, 2.56, 0.03);
  EXPECT_TRUE(pairsAt(60.0, 1.0).empty());
  EXPECT_EQ(pairsAt(7.0, 0.04).size(), 1U);
  EXPECT_TRUE(pairsAt(9.0, 0.04).empty());
}

TEST(BlobPairing, FindsTheBlobOfAPosition) {
  const CameraRig rig = twoOfThreeCameras();
  const BlobPairing pairing(rig);
  const Eigen::Vector3d ball(0.01, 0.02, 0.03);
  const std::vector<Blob> blobs{blobOf(rig[0], {0.0, 0.3, 0.0}), blobOf(rig[0], ball, 3.0),
                                blobOf(rig[0], ball, 0.8, {5.0, 0.0})};
  EXPECT_EQ(pairing.blobAt(0, blobs, ball, kTargetRadius), 2U) << "the second is too large";
  EXPECT_EQ(pairing.blobAt(0, blobs, ball, 0.0), 1U) << "which is not known here";
  EXPECT_FALSE(pairing.blobAt(0, blobs, {0.0, -0.3, 0.0}, kTargetRadius).has_value());
}

/// Something that camera 0's blob and camera 1's blob show; its position is exact.
PairedBlobs pairAt(const Eigen::Vector3d& position, double cost, std::size_t blob) {
  PairedBlobs pair;
  pair.point.position = position;
  pair.point.bearings = {{0, blob, {}, 1000.0}, {1, blob, {}, 1000.0}};
  pair.cost = cost;
  return pair;
}

ExpectedPosition expectedAtOrigin(double sigma) {
  return {Eigen::Vector3d::Zero(), sigma * sigma * Eigen::Matrix3d::Identity(), std::nullopt};
}

TEST(AssignPairs, WeighsLooksAgainstDistance) {
  // At 0.05 m: 1 + 0 against 0 + (0.1 / 0.05)² = 4. At 0.2 m: 1 + 0 against 0 + 0.25.
  const std::vector<PairedBlobs> pairs{pairAt({0, 0, 0}, 1.0, 0), pairAt({0.1, 0, 0}, 0.0, 1)};
  EXPECT_EQ(assignPairs(pairs, {expectedAtOrigin(0.05)})[0]->bearings[0].blob, 0U);
  EXPECT_EQ(assignPairs(pairs, {expectedAtOrigin(0.2)})[0]->bearings[0].blob, 1U);
}

TEST(AssignPairs, FarIsFar) {
  // 10 and 20 standard deviations both cost 9; the looks decide.
  const std::vector<PairedBlobs> pairs{pairAt({1, 0, 0}, 2.0, 0), pairAt({2, 0, 0}, 1.0, 1)};
  EXPECT_EQ(assignPairs(pairs, {expectedAtOrigin(0.1)})[0]->bearings[0].blob, 1U);
}

TEST(AssignPairs, TakesWhatIsOutsideTheGateOnlyAlone) {
  // Squared distances 20.25 and 16, gate 16.266.
  ExpectedPosition expected = expectedAtOrigin(0.1);
  expected.gate = 16.266;
  const std::vector<PairedBlobs> pairs{pairAt({0.45, 0, 0}, 0.0, 0), pairAt({0.4, 0, 0}, 9.0, 1)};
  EXPECT_EQ(assignPairs(pairs, {expected})[0]->bearings[0].blob, 1U);
  const auto alone = assignPairs({pairs.front()}, {expected});
  ASSERT_TRUE(alone[0].has_value());
  EXPECT_EQ(alone[0]->bearings[0].blob, 0U);
}

TEST(AssignPairs, GivesEachBlobOnce) {
  // The first target is at 0, the second at 0.1 m, and both would take the pair at 0.02 m first:
  // it goes to the first, which is nearer. The third pair shares a blob with it.
  ExpectedPosition second = expectedAtOrigin(0.1);
  second.mean.x() = 0.1;
  std::vector<PairedBlobs> pairs{pairAt({0.02, 0, 0}, 0.0, 0), pairAt({0.3, 0, 0}, 3.0, 1),
                                 pairAt({0.1, 0, 0}, 1.0, 2)};
  pairs[2].point.bearings[1].blob = 0;
  const auto result = assignPairs(pairs, {expectedAtOrigin(0.1), second});
  ASSERT_TRUE(result[0] && result[1]);
  EXPECT_EQ(result[0]->bearings[0].blob, 0U);
  EXPECT_EQ(result[1]->bearings[0].blob, 1U);
  pairs.erase(pairs.begin() + 1);
  EXPECT_FALSE(assignPairs(pairs, {expectedAtOrigin(0.1), second})[1].has_value());
  EXPECT_FALSE(assignPairs({}, {second})[0].has_value());
  EXPECT_TRUE(assignPairs(pairs, {}).empty());
}

} // namespace
} // namespace dewpoint::tests
