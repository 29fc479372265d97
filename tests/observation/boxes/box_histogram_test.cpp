// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/rgb_bins.h"
#include "core/observation/boxes/box_histogram.h"
#include "core/observation/boxes/histogram_similarity.h"
#include "tests/tracking/moving_patch.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <numeric>

namespace dewpoint::tests {
namespace {

TEST(BoxHistogram, IsThatOfTheMethod) {
  const MovingPatch scene;
  const cv::Mat image = scene.image(3);
  cv::Mat bins;
  findRgbBins(image, {{0, 0}, image.size()}, bins);
  // In the image, and across its left border.
  for (const ImageBox& box : {scene.box(3), ImageBox{-10.0, 60.0, 30.0, 21.0}}) {
    const std::vector<double> histogram = boxHistogram(image, box);
    const std::vector<double> expected =
        weightedHistogram(bins, kRgbBinCount, BoxKernel(int(box.width), int(box.height)),
                          box.center().x(), box.center().y());
    ASSERT_EQ(histogram.size(), expected.size());
    for (std::size_t bin = 0; bin < expected.size(); ++bin) {
      EXPECT_NEAR(histogram[bin], expected[bin], 1e-12) << bin;
    }
    EXPECT_NEAR(std::accumulate(histogram.begin(), histogram.end(), 0.0), 1.0, 1e-12);
  }
}

TEST(BoxHistogram, OfOneColorIsOneBin) {
  const cv::Mat red(40, 40, CV_8UC3, cv::Scalar(0, 0, 255));
  EXPECT_EQ(boxHistogram(red, {10, 10, 9, 7})[rgbBin(0, 0, 255)], 1.0);
}

TEST(BoxHistogram, IsEmptyOutsideTheImage) {
  const cv::Mat image(40, 40, CV_8UC3, cv::Scalar::all(90));
  EXPECT_TRUE(boxHistogram(image, {100, 10, 9, 7}).empty());
  EXPECT_TRUE(boxHistogram(cv::Mat(), {10, 10, 9, 7}).empty());
}

} // namespace
} // namespace dewpoint::tests
