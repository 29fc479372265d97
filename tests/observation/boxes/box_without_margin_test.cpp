// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/boxes/box_without_margin.h"
#include "core/observation/boxes/target_colors.h"
#include "tests/tracking/moving_patch.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(BoxWithoutMargin, LeavesOutTheMarginOfADrawnBox) {
  const MovingPatch scene; // clear colors on grays: the figure is where the patch is
  const cv::Mat image = scene.image(0);
  const ImageBox truth = scene.box(0);
  for (const double scale : {1.0, 1.2, 1.4}) {
    for (const double shift : {-0.15, 0.0, 0.15}) {
      const ImageBox drawn =
          ImageBox::around(truth.center() + Eigen::Vector2d(shift * scene.side, 0.0),
                           scale * scene.side, scale * scene.side);
      const ImageBox figure = boxWithoutMargin(image, drawn);
      // What of the patch is in the drawn box, to a pixel or two at each side.
      EXPECT_GT(intersectionArea(figure, truth), 0.85 * intersectionArea(drawn, truth))
          << scale << ' ' << shift;
      EXPECT_GT(intersectionArea(figure, truth), 0.85 * figure.area()) << scale << ' ' << shift;
    }
  }
}

TEST(BoxWithoutMargin, IsTheDrawnBoxWhereNothingStandsOut) {
  const cv::Mat gray(120, 160, CV_8UC3, cv::Scalar(90, 90, 90));
  const ImageBox drawn{40.0, 30.0, 33.0, 21.0};
  EXPECT_EQ(boxWithoutMargin(gray, drawn), drawn);
}

TEST(BoxWithoutMargin, KeepsHalfOfEachSide) {
  cv::Mat image(120, 160, CV_8UC3, cv::Scalar(90, 90, 90));
  cv::rectangle(image, {76, 56, 8, 8}, cv::Scalar(0, 0, 255), cv::FILLED);
  const ImageBox figure = boxWithoutMargin(image, {60.0, 40.0, 40.0, 40.0});
  EXPECT_EQ(figure.width, 20.0); // half of 40, though only 8 are red
  EXPECT_EQ(figure.height, 20.0);
  EXPECT_EQ(intersectionArea(figure, {76.0, 56.0, 8.0, 8.0}), 64.0);
}

TEST(BoxWithoutMargin, MayReachOutOfTheImage) {
  const MovingPatch scene;
  const ImageBox figure = boxWithoutMargin(scene.image(0), {-10.0, -10.0, 30.0, 30.0});
  EXPECT_FALSE(figure.isEmpty());
}

TEST(TargetColors, DoNotLearnTheGroundInTheBox) {
  cv::Mat image(120, 160, CV_8UC3, cv::Scalar(90, 90, 90));
  const ImageBox box{60.0, 40.0, 40.0, 40.0};
  cv::rectangle(image, {60, 40, 40, 40}, cv::Scalar(0, 0, 255), cv::FILLED);
  TargetColors colors;
  colors.learn(image, box);
  EXPECT_NEAR(colors.similarityOf(image, box), 1.0, 1e-2); // red is in the box alone
  const cv::Mat empty(120, 160, CV_8UC3, cv::Scalar(90, 90, 90));
  EXPECT_EQ(colors.similarityOf(empty, box), 0.0);
  for (int i = 0; i < 50; ++i) {
    colors.adaptTarget(empty, box, 0.2);
  }
  const BinShares shares = colors.binShares(0);
  constexpr std::size_t kGrayBin = 5 * 256 + 5 * 16 + 5; // 90 / 16 = 5 in each of 16 levels
  EXPECT_EQ(shares[kGrayBin], 0);                        // the ground is not taken for the target
}

} // namespace
} // namespace dewpoint::tests
