// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_classifier.h"

#include "core/base/vector_kernel.h"

#include <array>
#include <cstddef>

namespace dewpoint::color {
namespace {

struct EitherRangeKernel {
  DEWPOINT_KERNEL void run(const std::uint8_t* __restrict other, std::int64_t count,
                           std::uint8_t* __restrict matched) {
    for (std::int64_t i = 0; i < count; ++i) {
      matched[i] |= other[i];
    }
  }
};

} // namespace

ColorClassifier::ColorClassifier(const ColorRanges& ranges) : first_(ranges[0]) {
  others_.reserve(ranges.size() - 1);
  for (std::size_t k = 1; k < ranges.size(); ++k) {
    others_.emplace_back(ranges[k]);
  }
}

void ColorClassifier::matchRow(const std::uint8_t* bgr, std::int64_t count,
                               std::uint8_t* out) const noexcept {
  first_.matchRow(bgr, count, out);
  constexpr std::int64_t kBlock = 1024; // pixels, as RangeClassifier takes them
  std::array<std::uint8_t, kBlock> matched;
  for (const RangeClassifier& other : others_) {
    for (std::int64_t begin = 0; begin < count; begin += kBlock) {
      const std::int64_t length = std::min(kBlock, count - begin);
      other.matchRow(bgr + 3 * begin, length, matched.data());
      runKernel<EitherRangeKernel>(static_cast<const std::uint8_t*>(matched.data()), length,
                                   out + begin);
    }
  }
}

} // namespace dewpoint::color
