// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/clear_mot.h"
#include "tests/experiment/metrics/track_frames.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dewpoint::tests {
namespace {

constexpr double kMotGate = 0.5;

TEST(ClearMot, NothingAtAll) {
  const ClearMot result = computeClearMot(std::vector<TrackFrame>{frameOnAxis({}, {})}, kMotGate);
  EXPECT_TRUE(std::isnan(result.mota()));
  EXPECT_TRUE(std::isnan(result.motp()));
  EXPECT_TRUE(std::isnan(computeClearMot({}, kMotGate).mota()));
}

// Estimate 10 stays matched at 0.3 although 11 sits on the truth: 11 is a false positive.
// MOTA = 1 - 1 / 2, MOTP = (0.1 + 0.3) / 2.
TEST(ClearMot, AMatchIsKeptWhileItIsValid) {
  const std::vector<TrackFrame> frames{frameOnAxis({{1, 0.0}}, {{10, 0.1}}),
                                       frameOnAxis({{1, 0.0}}, {{11, 0.0}, {10, 0.3}})};
  const ClearMot result = computeClearMot(frames, kMotGate);
  EXPECT_EQ(result.matches, 2);
  EXPECT_EQ(result.misses, 0);
  EXPECT_EQ(result.falsePositives, 1);
  EXPECT_EQ(result.identitySwitches, 0);
  EXPECT_DOUBLE_EQ(result.mota(), 0.5);
  EXPECT_DOUBLE_EQ(result.motp(), 0.2);
}

// Beyond the gate (0.6) the match is given up for 11: one switch. MOTA = 1 - (1 + 1) / 2.
TEST(ClearMot, AMatchBeyondTheGateIsReplaced) {
  const std::vector<TrackFrame> frames{frameOnAxis({{1, 0.0}}, {{10, 0.1}}),
                                       frameOnAxis({{1, 0.0}}, {{10, 0.6}, {11, 0.0}})};
  const ClearMot result = computeClearMot(frames, kMotGate);
  EXPECT_EQ(result.identitySwitches, 1);
  EXPECT_EQ(result.falsePositives, 1);
  EXPECT_DOUBLE_EQ(result.mota(), 0.0);
}

// Two estimates change places: a switch for each truth. MOTA = 1 - 2 / 4.
TEST(ClearMot, ASwapCountsTwice) {
  const std::vector<TrackFrame> frames{frameOnAxis({{1, 0.0}, {2, 10.0}}, {{10, 0.0}, {11, 10.0}}),
                                       frameOnAxis({{1, 0.0}, {2, 10.0}}, {{11, 0.0}, {10, 10.0}})};
  const ClearMot result = computeClearMot(frames, kMotGate);
  EXPECT_EQ(result.identitySwitches, 2);
  EXPECT_EQ(result.misses + result.falsePositives, 0);
  EXPECT_DOUBLE_EQ(result.mota(), 0.5);
  EXPECT_EQ(result.fragmentations, 0);
}

std::vector<TrackFrame> withGap(int identityAfter) {
  return {frameOnAxis({{1, 0.0}}, {{10, 0.0}}), frameOnAxis({{1, 0.0}}, {{10, 0.0}}),
          frameOnAxis({{1, 0.0}}, {}), frameOnAxis({{1, 0.0}}, {{identityAfter, 0.0}}),
          frameOnAxis({{1, 0.0}}, {{identityAfter, 0.0}})};
}

// One miss in five frames: MOTA = 1 - 1 / 5 when the identity comes back, 1 - 2 / 5 with a new one.
TEST(ClearMot, GapsFragmentAndIdentitiesAreRemembered) {
  const ClearMot same = computeClearMot(withGap(10), kMotGate);
  EXPECT_EQ(same.misses, 1);
  EXPECT_EQ(same.fragmentations, 1);
  EXPECT_EQ(same.identitySwitches, 0);
  EXPECT_DOUBLE_EQ(same.mota(), 0.8);
  const ClearMot other = computeClearMot(withGap(11), kMotGate);
  EXPECT_EQ(other.fragmentations, 1);
  EXPECT_EQ(other.identitySwitches, 1);
  EXPECT_DOUBLE_EQ(other.mota(), 0.6);
}

// The truth itself is away for a frame: neither missed nor fragmented.
TEST(ClearMot, AnAbsentTruthIsNoGap) {
  std::vector<TrackFrame> frames = withGap(10);
  frames[2].truth.clear();
  const ClearMot result = computeClearMot(frames, kMotGate);
  EXPECT_EQ(result.truthCount, 4);
  EXPECT_EQ(result.misses, 0);
  EXPECT_EQ(result.fragmentations, 0);
  EXPECT_DOUBLE_EQ(result.mota(), 1.0);
}

TEST(ClearMot, TheBeginningAndTheEndAreNoFragmentation) {
  const std::vector<TrackFrame> frames{frameOnAxis({{1, 0.0}}, {}),
                                       frameOnAxis({{1, 0.0}}, {{10, 0.0}}),
                                       frameOnAxis({{1, 0.0}}, {})};
  const ClearMot result = computeClearMot(frames, kMotGate);
  EXPECT_EQ(result.misses, 2);
  EXPECT_EQ(result.fragmentations, 0);
}

// Estimates at 0.1 and 0.35 of truths at 0 and 0.4: 0.1 + 0.05 = 0.15 is less than 0.35 + 0.3.
// Estimates at 0.3 and 0.85: the nearest pair, 2 with 10 at 0.1, would leave truth 1 without any
// (0.85 is beyond the gate); 1 with 10 and 2 with 11 make two, 0.3 + 0.45 = 0.75.
TEST(ClearMot, AsManyMatchesAsPossibleThenLeastDistance) {
  const std::vector<TrackFrame> least{frameOnAxis({{1, 0.0}, {2, 0.4}}, {{10, 0.35}, {11, 0.1}})};
  EXPECT_EQ(computeClearMot(least, kMotGate).matches, 2);
  EXPECT_NEAR(computeClearMot(least, kMotGate).distanceSum, 0.15, 1e-15);
  const std::vector<TrackFrame> most{frameOnAxis({{1, 0.0}, {2, 0.4}}, {{10, 0.3}, {11, 0.85}})};
  EXPECT_EQ(computeClearMot(most, kMotGate).matches, 2);
  EXPECT_NEAR(computeClearMot(most, kMotGate).distanceSum, 0.75, 1e-15);
}

// Truth 2 took over estimate 10 while truth 1 was away. When both are near, it belongs to 2, which
// had it last: 1 is missed, nobody switched. MOTA = 1 - 1 / 4, MOTP = (0 + 0 + 0.1) / 3.
TEST(ClearMot, AnIdentityBelongsToTheTruthThatHadItLast) {
  const std::vector<TrackFrame> frames{frameOnAxis({{1, 0.0}}, {{10, 0.0}}),
                                       frameOnAxis({{2, 0.0}}, {{10, 0.0}}),
                                       frameOnAxis({{1, 0.15}, {2, 0.2}}, {{10, 0.1}})};
  const ClearMot result = computeClearMot(frames, kMotGate);
  EXPECT_EQ(result.matches, 3);
  EXPECT_EQ(result.misses, 1);
  EXPECT_EQ(result.identitySwitches, 0);
  EXPECT_DOUBLE_EQ(result.mota(), 0.75);
  EXPECT_NEAR(result.motp(), 0.1 / 3.0, 1e-15);
}

// Declared, but nowhere: one miss and one false positive of one truth, MOTA = 1 - 2 / 1.
TEST(ClearMot, AnEstimateThatIsNoNumber) {
  const std::vector<TrackFrame> frames{
      frameOnAxis({{1, 0.0}}, {{10, std::numeric_limits<double>::quiet_NaN()}})};
  const ClearMot result = computeClearMot(frames, kMotGate);
  EXPECT_EQ(result.misses, 1);
  EXPECT_EQ(result.falsePositives, 1);
  EXPECT_DOUBLE_EQ(result.mota(), -1.0);
  EXPECT_TRUE(std::isnan(result.motp()));
}

TEST(ClearMot, TheGateItselfStillMatches) {
  EXPECT_EQ(computeClearMot(std::vector<TrackFrame>{frameOnAxis({{1, 0.0}}, {{10, 0.5}})}, kMotGate)
                .matches,
            1);
}

} // namespace
} // namespace dewpoint::tests
