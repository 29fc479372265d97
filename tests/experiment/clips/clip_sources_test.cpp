// SPDX-License-Identifier: GPL-3.0-or-later
// The truth of real clips: that which is kept here, and that of the recordings where they are.
#include "core/experiment/clips/clip_sources.h"
#include "core/experiment/clips/clip_table.h"
#include "core/geometry/projector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>

namespace dewpoint::tests {
namespace {

namespace fs = std::filesystem;

const fs::path kTruth = fs::path(DEWPOINT_SOURCE_DIR) / "bench" / "clips";

ClipFolders folders() {
  const char* data = std::getenv("DEWPOINT_DATA");
  return {data != nullptr ? fs::path(data) : fs::path(), kTruth};
}

TEST(HandClip, HasFortyMarkedFramesThatAgreeWithTheirPositions) {
  const auto clip = handClip({"none", kTruth}); // the recording itself is not read here
  ASSERT_TRUE(clip) << errorSentence(clip.error());
  ASSERT_EQ(clip->rig.size(), 2U);
  EXPECT_EQ(clip->positions.size(), 40U); // bench/clips/README.md
  EXPECT_EQ(clip->markedCenters.size(), 80U);
  EXPECT_EQ(clip->instants.size(), 352U); // frames 12 to 363
  EXPECT_EQ(clip->instants.front().frames, (std::vector<std::int64_t>{12, 12}));
  EXPECT_EQ(clip->targets.front().click.frame, 9) << "frame 21";
  const auto residuals = readClipTable(kTruth / "hand2_desk.csv", {"residual_px"});
  ASSERT_TRUE(residuals);
  for (std::size_t k = 0; k < clip->positions.size(); ++k) {
    double sum = 0.0;
    for (std::size_t camera = 0; camera < 2; ++camera) {
      const MarkedCenter& mark = clip->markedCenters[2 * k + camera];
      EXPECT_EQ(mark.frame, clip->positions[k].instant);
      const auto pixel = Projector(clip->rig[camera]).project(clip->positions[k].position);
      ASSERT_TRUE(pixel.has_value());
      sum += (*pixel - mark.pixel).squaredNorm();
    }
    // Positions are written with 0.1 mm, a tenth of a pixel; residuals with 0.1 px.
    EXPECT_NEAR(std::sqrt(sum / 2.0), residuals->rows[k][0], 0.2) << "row " << k;
    EXPECT_LT(residuals->rows[k][0], 7.5); // the largest is 7.1, README
    EXPECT_GT(clip->positions[k].position.z(), -0.015) << "above the desk";
  }
}

TEST(HandClip, IsTheMeanOfItsPasses) {
  const std::vector<std::string> pixels{"frame", "u0", "v0", "u1", "v1"};
  const auto truth = readClipTable(kTruth / "hand2_desk.csv", pixels);
  const auto passes = readClipTable(kTruth / "hand2_desk_passes.csv", pixels);
  ASSERT_TRUE(truth && passes);
  EXPECT_EQ(passes->rows.size(), 51U); // 40 frames once, ten of them twice, and frame 330
  for (const auto& row : truth->rows) {
    std::vector<double> sum(5, 0.0);
    double count = 0.0;
    for (const auto& mark : passes->rows) {
      if (mark[0] == row[0]) {
        count += 1.0;
        for (std::size_t k = 0; k < 5; ++k) {
          sum[k] += mark[k];
        }
      }
    }
    ASSERT_GT(count, 0.0) << "frame " << row[0];
    for (std::size_t k = 0; k < 5; ++k) {
      EXPECT_DOUBLE_EQ(sum[k] / count, row[k]) << "frame " << row[0];
    }
  }
}

TEST(BoardClip, HasTheBoardsCenterAtEveryInstant) {
  if (!fs::exists(folders().recordings / "charuco4")) {
    GTEST_SKIP() << "the recording charuco4 is not in DEWPOINT_DATA";
  }
  const auto clip = boardClip(folders());
  ASSERT_TRUE(clip) << errorSentence(clip.error());
  EXPECT_EQ(clip->instants.size(), 57U); // README of the recording
  // Corners are missing at the first nine instants, but at least one pair of opposite ones is
  // there.
  EXPECT_EQ(clip->positions.size(), 57U);
  EXPECT_EQ(clip->instants[3].frames, (std::vector<std::int64_t>{3, 3, 3, 3}));
  // Worked from the file: the mean of the pairs 0-11, 3-8, 4-7, 5-6 at sync_index 35.
  EXPECT_LT((clip->positions.front().position - Eigen::Vector3d(0.5241, 0.4204, 0.0237)).norm(),
            2e-4);
  EXPECT_LT((clip->positions.back().position - Eigen::Vector3d(-0.0136, 0.0574, 0.1423)).norm(),
            2e-4);
}

TEST(BandsClip, HasThreeBandsInEveryFrame) {
  if (!fs::exists(folders().recordings / "tapes2_limbs")) {
    GTEST_SKIP() << "the recording tapes2_limbs is not in DEWPOINT_DATA";
  }
  const auto clip = bandsClip(folders());
  ASSERT_TRUE(clip) << errorSentence(clip.error());
  EXPECT_EQ(clip->instants.size(), 163U); // README of the recording
  EXPECT_EQ(clip->markedCenters.size(), 163U * 3U * 2U);
  ASSERT_EQ(clip->startPositions.size(), 3U);
  // Worked from the file by the midpoint of the two rays, in baselines and the left camera's axes:
  // the yellow band is at (-0.309, 1.066, 8.113) in the first frame.
  const Eigen::Vector3d yellow = kBandBaseline * Eigen::Vector3d(-0.309, 8.113, -1.066);
  EXPECT_LT((clip->startPositions[0] - yellow).norm(), 0.005);
  EXPECT_NEAR((clip->rig[0].center() - clip->rig[1].center()).norm(), kBandBaseline, 1e-9);
}

} // namespace
} // namespace dewpoint::tests
