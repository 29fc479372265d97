// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/boxes/box_kernel.h"

#include <gtest/gtest.h>

namespace dewpoint::tests {
namespace {

TEST(BoxKernel, OfABoxLiesOnWholePixelsAtLeastOne) {
  const BoxKernel kernel(ImageBox{3.2, 4.7, 10.6, 7.4});
  EXPECT_EQ(kernel.width(), 11);
  EXPECT_EQ(kernel.height(), 7);
  const BoxKernel small(ImageBox{3.2, 4.7, 0.2, 0.0});
  EXPECT_EQ(small.width(), 1);
  EXPECT_EQ(small.height(), 1);
}

} // namespace
} // namespace dewpoint::tests
