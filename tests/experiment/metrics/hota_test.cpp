// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/hota.h"
#include "tests/experiment/metrics/track_frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dewpoint::tests {
namespace {

constexpr double kHotaGate = 0.1; // similarity = 1 - distance / 0.1

TEST(Hota, PerfectIsOne) {
  const std::vector<TrackFrame> frames{frameOnAxis({{1, 0.0}, {2, 1.0}}, {{7, 0.0}, {8, 1.0}}),
                                       frameOnAxis({{1, 0.1}, {2, 0.9}}, {{7, 0.1}, {8, 0.9}})};
  const Hota result = computeHota(frames, kHotaGate);
  EXPECT_DOUBLE_EQ(result.hota, 1.0);
  EXPECT_DOUBLE_EQ(result.detectionAccuracy, 1.0);
  EXPECT_DOUBLE_EQ(result.associationAccuracy, 1.0);
  EXPECT_DOUBLE_EQ(result.localizationAccuracy, 1.0);
}

// Four frames, one truth: estimate 10 on it (similarity 1) twice, then estimate 11 at 0.05
// (similarity 0.5) twice.
// Thresholds 0.05 to 0.50 (10 of them): TP 4, so DetA = 1; each identity shares 2 frames with the
// truth, 2 / (4 + 2 - 2) = 1/2, so AssA = 1/2; HOTA = sqrt(1/2); LocA = (1 + 1 + 0.5 + 0.5) / 4.
// Thresholds 0.55 to 0.95 (9): TP 2, FN 2, FP 2, so DetA = 1/3; AssA = 1/2 still;
// HOTA = sqrt(1/6); LocA = 1.
TEST(Hota, FourFramesByHand) {
  const std::vector<TrackFrame> frames{
      frameOnAxis({{1, 0.0}}, {{10, 0.0}}), frameOnAxis({{1, 0.0}}, {{10, 0.0}}),
      frameOnAxis({{1, 0.0}}, {{11, 0.05}}), frameOnAxis({{1, 0.0}}, {{11, 0.05}})};
  const Hota result = computeHota(frames, kHotaGate);
  EXPECT_EQ(result.thresholds[9].threshold, 0.5);
  EXPECT_EQ(result.thresholds[9].matches, 4);
  EXPECT_DOUBLE_EQ(result.thresholds[9].hota, std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(result.thresholds[9].localizationAccuracy, 0.75);
  EXPECT_EQ(result.thresholds[10].matches, 2);
  EXPECT_EQ(result.thresholds[10].misses, 2);
  EXPECT_EQ(result.thresholds[10].falsePositives, 2);
  EXPECT_DOUBLE_EQ(result.thresholds[10].detectionAccuracy, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(result.thresholds[10].associationAccuracy, 0.5);
  EXPECT_NEAR(result.detectionAccuracy, (10.0 + 9.0 / 3.0) / 19.0, 1e-14);
  EXPECT_NEAR(result.associationAccuracy, 0.5, 1e-14);
  EXPECT_NEAR(result.localizationAccuracy, (10.0 * 0.75 + 9.0) / 19.0, 1e-14);
  EXPECT_NEAR(result.hota, (10.0 * std::sqrt(0.5) + 9.0 * std::sqrt(1.0 / 6.0)) / 19.0, 1e-14);
}

// In the last of four frames estimate 11 is nearer (0.04, similarity 0.6) than 10 (0.06, 0.4),
// which was the truth's partner in the other three. Shared frames: with 10, 3 + 0.4 / (1.0 + 0.4 -
// 0.4) = 3.4, alignment 3.4 / (4 + 4 - 3.4) = 0.739; with 11, 0.6 and 0.6 / (4 + 1 - 0.6) = 0.136.
// 0.739 * 0.4 = 0.296 beats 0.136 * 0.6 = 0.082: the old partner is matched.
// Thresholds to 0.40 (8): TP 4, FP 1, DetA = 4/5, AssA = 4 / 4; from 0.45 (11): TP 3, FN 1, FP 2,
// DetA = 3/6, AssA = 3 / (4 + 4 - 3) = 3/5.
TEST(Hota, TheLongPartnershipIsPreferred) {
  std::vector<TrackFrame> frames(3, frameOnAxis({{1, 0.0}}, {{10, 0.0}}));
  frames.push_back(frameOnAxis({{1, 0.0}}, {{11, 0.04}, {10, 0.06}}));
  const Hota result = computeHota(frames, kHotaGate);
  EXPECT_EQ(result.thresholds[7].matches, 4);
  EXPECT_DOUBLE_EQ(result.thresholds[7].detectionAccuracy, 0.8);
  EXPECT_DOUBLE_EQ(result.thresholds[7].associationAccuracy, 1.0);
  EXPECT_DOUBLE_EQ(result.thresholds[8].detectionAccuracy, 0.5);
  EXPECT_DOUBLE_EQ(result.thresholds[8].associationAccuracy, 0.6);
  EXPECT_NEAR(result.hota, (8.0 * std::sqrt(0.8) + 11.0 * std::sqrt(0.3)) / 19.0, 1e-14);
}

// Two truths whose estimates swap half way: every detection is there (DetA = 1); each of the four
// pairs of identities shares 1 of 2 frames, 1 / (2 + 2 - 1) = 1/3. HOTA = sqrt(1/3).
TEST(Hota, ASwapHalvesTheAssociationNotTheDetection) {
  const std::vector<TrackFrame> frames{frameOnAxis({{1, 0.0}, {2, 1.0}}, {{10, 0.0}, {11, 1.0}}),
                                       frameOnAxis({{1, 0.0}, {2, 1.0}}, {{11, 0.0}, {10, 1.0}})};
  const Hota result = computeHota(frames, kHotaGate);
  EXPECT_DOUBLE_EQ(result.detectionAccuracy, 1.0);
  EXPECT_NEAR(result.associationAccuracy, 1.0 / 3.0, 1e-15);
  EXPECT_NEAR(result.hota, std::sqrt(1.0 / 3.0), 1e-15);
}

TEST(Hota, NothingToJudge) {
  EXPECT_TRUE(std::isnan(computeHota({}, kHotaGate).hota));
  const Hota missed = computeHota(std::vector<TrackFrame>{frameOnAxis({{1, 0.0}}, {})}, kHotaGate);
  EXPECT_EQ(missed.hota, 0.0);
  EXPECT_TRUE(std::isnan(missed.localizationAccuracy));
  EXPECT_EQ(computeHota(std::vector<TrackFrame>{frameOnAxis({}, {{1, 0.0}})}, kHotaGate).hota, 0.0);
}

// The second of two frames is declared but nowhere: TP 1, FN 1, FP 1, DetA = 1/3;
// AssA = 1 / (2 + 2 - 1) = 1/3; HOTA = sqrt(1/9).
TEST(Hota, AnEstimateThatIsNoNumber) {
  const std::vector<TrackFrame> frames{
      frameOnAxis({{1, 0.0}}, {{10, 0.0}}),
      frameOnAxis({{1, 0.0}}, {{10, std::numeric_limits<double>::quiet_NaN()}})};
  EXPECT_NEAR(computeHota(frames, kHotaGate).hota, 1.0 / 3.0, 1e-15);
}

} // namespace
} // namespace dewpoint::tests
