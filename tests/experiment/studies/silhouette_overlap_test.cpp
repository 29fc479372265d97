// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/studies/person_tally.h"
#include "core/experiment/studies/silhouette_overlap.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dewpoint::tests {
namespace {

/// A mask of 20 x 12 pixels with a rectangle.
cv::Mat maskOf(const cv::Rect& area) {
  cv::Mat mask = cv::Mat::zeros(12, 20, CV_8UC1);
  mask(area).setTo(cv::Scalar(255));
  return mask;
}

// Columns 10 to 19 and rows 5 to 8 have their centers inside.
TEST(FilledOutline, HoldsThePixelsWhoseCentersLieInside) {
  const cv::Mat mask =
      filledOutline({{9.6, 4.6}, {19.4, 4.6}, {19.4, 8.4}, {9.6, 8.4}}, cv::Size(30, 20));
  EXPECT_EQ(cv::countNonZero(mask), 40);
  EXPECT_EQ(cv::countNonZero(mask(cv::Rect(10, 5, 10, 4))), 40);
  // The other way around it is the same.
  EXPECT_EQ(cv::countNonZero(filledOutline({{9.6, 8.4}, {19.4, 8.4}, {19.4, 4.6}, {9.6, 4.6}},
                                           cv::Size(30, 20))),
            40);
}

// Rows of 5, 4, 3, 2 and 1 pixels: their centers on the border count.
TEST(FilledOutline, FillsATriangle) {
  EXPECT_EQ(cv::countNonZero(filledOutline({{0.0, 0.0}, {4.0, 0.0}, {0.0, 4.0}}, cv::Size(9, 9))),
            15);
}

TEST(FilledOutline, IsCutByTheImage) {
  // Columns and rows 0 to 2 of an outline that begins outside.
  EXPECT_EQ(cv::countNonZero(filledOutline({{-5.0, -5.0}, {2.5, -5.0}, {2.5, 2.5}, {-5.0, 2.5}},
                                           cv::Size(10, 10))),
            9);
  // An outline that holds the whole image, and one beside it.
  EXPECT_EQ(cv::countNonZero(filledOutline({{-1e6, -1e6}, {1e6, -1e6}, {1e6, 1e6}, {-1e6, 1e6}},
                                           cv::Size(10, 10))),
            100);
  EXPECT_EQ(cv::countNonZero(filledOutline({{20.0, 2.0}, {30.0, 2.0}, {30.0, 8.0}}, {10, 10})), 0);
  EXPECT_EQ(cv::countNonZero(filledOutline({{1.0, 1.0}, {5.0, 5.0}}, cv::Size(10, 10))), 0);
}

// The whole body: 10 x 10 pixels, of which the lower four rows are hidden: 60 visible ones. The
// estimate: columns 5 to 14, rows 3 to 8, 60 pixels, of which 5 x 3 lie on the visible part, and
// 5 x 3 where the body is hidden, which do not count: 45.
TEST(SilhouetteOverlap, CountsAsByHand) {
  const SilhouetteOverlap overlap =
      overlapOf(maskOf({5, 3, 10, 6}), maskOf({0, 0, 10, 6}), maskOf({0, 0, 10, 10}));
  EXPECT_EQ(overlap.commonPixelCount, 15);
  EXPECT_EQ(overlap.truePixelCount, 60);
  EXPECT_EQ(overlap.estimatedPixelCount, 45);
  EXPECT_DOUBLE_EQ(overlap.recall(), 15.0 / 60.0);
  EXPECT_DOUBLE_EQ(overlap.precision(), 15.0 / 45.0);
  EXPECT_DOUBLE_EQ(overlap.iou(), 15.0 / 90.0);
}

TEST(SilhouetteOverlap, IsWholeForTheSameAndNothingBesideEachOther) {
  const cv::Mat body = maskOf({2, 2, 4, 6});
  const SilhouetteOverlap same = overlapOf(body, body, body);
  EXPECT_EQ(same.recall(), 1.0);
  EXPECT_EQ(same.precision(), 1.0);
  EXPECT_EQ(same.iou(), 1.0);
  const SilhouetteOverlap beside = overlapOf(maskOf({10, 2, 4, 6}), body, body);
  EXPECT_EQ(beside.recall(), 0.0);
  EXPECT_EQ(beside.precision(), 0.0);
  EXPECT_EQ(beside.iou(), 0.0);
}

TEST(SilhouetteOverlap, AnEmptyEstimateHasNoPrecision) {
  const cv::Mat body = maskOf({2, 2, 4, 6});
  const cv::Mat nothing = cv::Mat::zeros(body.size(), CV_8UC1);
  const SilhouetteOverlap overlap = overlapOf(nothing, body, body);
  EXPECT_EQ(overlap.recall(), 0.0);
  EXPECT_TRUE(std::isnan(overlap.precision()));
  EXPECT_EQ(overlap.iou(), 0.0);
}

TEST(PersonTally, AveragesWhatThereIs) {
  PersonTally tally;
  EXPECT_TRUE(std::isnan(tally.result(1.1).found));
  EXPECT_TRUE(std::isnan(tally.result(1.1).silhouette.recall));
  tally.addFrame(true);
  tally.addFrame(false);
  tally.addFrame(false);
  tally.addFrame(false);
  tally.addSilhouette({10, 20, 10}); // recall 1/2, precision 1, IoU 1/2
  tally.addSilhouette({10, 40, 40}); // 1/4, 1/4, 1/7
  tally.addSilhouette({0, 10, 0});   // 0, none, 0
  tally.addHeightError(-0.1);
  tally.addHeightError(0.3);
  const PersonResult result = tally.result(1.1);
  EXPECT_EQ(result.height, 1.1);
  EXPECT_DOUBLE_EQ(result.found, 0.25);
  EXPECT_DOUBLE_EQ(result.silhouette.recall, 0.25);
  EXPECT_DOUBLE_EQ(result.silhouette.precision, 0.625);
  EXPECT_DOUBLE_EQ(result.silhouette.iou, (0.5 + 1.0 / 7.0) / 3.0);
  EXPECT_DOUBLE_EQ(result.heightError, 0.2);
}

} // namespace
} // namespace dewpoint::tests
