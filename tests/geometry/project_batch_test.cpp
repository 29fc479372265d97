// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/instruction_set.h"
#include "core/base/random.h"
#include "core/geometry/camera.h"
#include "core/geometry/projector.h"
#include "tests/base/not_a_number.h"
#include "tests/geometry/webcam.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace dewpoint::tests {
namespace {

constexpr Eigen::Index kCount = 1003; // not a multiple of any vector

/// Points all around the camera: visible, behind it, beyond the fold of the distortion, and a few
/// that are no points at all.
Eigen::ArrayXXd points() {
  const RandomStream stream(8, 0, 0, RandomPurpose::Noise);
  Eigen::ArrayXXd result(kCount, 3);
  for (Eigen::Index i = 0; i < kCount; ++i) {
    const auto unit = stream.uniform3(static_cast<std::uint32_t>(i));
    result.row(i) << 4.0 * unit[0] - 2.0, 4.0 * unit[1] - 2.0, 2.0 * unit[2] - 1.0;
  }
  result(100, 0) = kNotANumber;
  result(200, 1) = std::numeric_limits<double>::infinity();
  result.row(300) << 0.5, 0.0, 0.195; // the optical center
  return result;
}

bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
         (std::isnan(a) && std::isnan(b));
}

TEST(ProjectBatch, IsEqualToPointByPointForEveryInstructionSet) {
  const Eigen::ArrayXXd p = points();
  for (const std::array<double, 8>& distortion :
       {std::array<double, 8>{},
        {-0.28, 0.07, 0.0012, -0.0008, 0.004},
        {0.12, 0.03, -7e-4, 1e-3, 0.002, 0.2, 0.04, 0.003}}) {
    const Projector projector(webcam(distortion));
    for (const InstructionSet limit :
         {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512}) {
      const InstructionSetLimit limited(limit);
      Eigen::ArrayXd column(kCount);
      Eigen::ArrayXd row(kCount);
      projector.projectBatch(kCount, p.col(0).data(), p.col(1).data(), p.col(2).data(),
                             column.data(), row.data());
      int visible = 0;
      for (Eigen::Index i = 0; i < kCount; ++i) {
        const auto pixel = projector.project({p(i, 0), p(i, 1), p(i, 2)});
        ASSERT_TRUE(same(pixel ? pixel->x() : kNotANumber, column[i])) << i;
        ASSERT_TRUE(same(pixel ? pixel->y() : kNotANumber, row[i])) << i;
        visible += pixel ? 1 : 0;
      }
      EXPECT_GT(visible, 100);
      EXPECT_LT(visible, kCount - 100);
    }
  }
}

} // namespace
} // namespace dewpoint::tests
