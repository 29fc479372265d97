// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/image_bounds.h"

#include <gtest/gtest.h>

#include <limits>

namespace dewpoint::tests {
namespace {

TEST(ImageBounds, AreTheCentersOfTheOutermostPixels) {
  Intrinsics image;
  image.width = 640;
  image.height = 480;
  EXPECT_TRUE(isInImage(image, {0.0, 0.0}));
  EXPECT_TRUE(isInImage(image, {639.0, 479.0}));
  EXPECT_FALSE(isInImage(image, {-0.1, 10.0}));
  EXPECT_FALSE(isInImage(image, {10.0, -0.1}));
  EXPECT_FALSE(isInImage(image, {639.1, 10.0}));
  EXPECT_FALSE(isInImage(image, {10.0, 479.1}));
  EXPECT_FALSE(isInImage(image, {std::numeric_limits<double>::quiet_NaN(), 10.0}));
}

} // namespace
} // namespace dewpoint::tests
