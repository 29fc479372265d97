// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/filter/sorted_draws.h"

#include "core/base/elementary.h"
#include "core/base/vector_kernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace dewpoint::filter {
namespace {

constexpr std::int64_t kBlockSize = SortedDraws::kBlockSize;

/// A number of the Gamma distribution of a shape >= 1 and scale 1 (Marsaglia & Tsang 2000). Words
/// of block 0 of the element stay unused.
double gammaVariate(double shape, const RandomStream& stream, std::uint32_t element) {
  const double d = shape - 1.0 / 3.0;
  const double c = 1.0 / std::sqrt(9.0 * d);
  for (std::uint32_t block = 1;; block += 2) {
    const double x = stream.normal4(element, block)[0];
    const double root = 1.0 + c * x;
    if (root <= 0.0) {
      continue;
    }
    const double v = root * root * root;
    const double unit = stream.uniform(element, block + 1) + 0x1.0p-54;
    if (logarithm(unit) < 0.5 * x * x + d - d * v + d * logarithm(v)) {
      return d * v;
    }
  }
}

/// Draws of some stretches from the sums within each: begin + (before + sum) * ratio, times scale.
struct PlaceKernel {
  DEWPOINT_KERNEL void run(std::int64_t count, const double* __restrict sums, double before,
                           double ratio, double begin, double scale, double limit,
                           double* __restrict draws) {
    for (std::int64_t i = 0; i < count; ++i) {
      const double draw = (begin + (before + sums[i]) * ratio) * scale;
      draws[i] = draw < limit ? draw : limit;
    }
  }
};

} // namespace

SortedDraws::SortedDraws(const RandomStream& stream, std::int64_t count, double total)
    : stream_(stream), count_(count) {
  const std::int64_t spacings = count + 1;
  begins_.assign(1, 0.0);
  for (std::int64_t begin = 0; begin < spacings; begin += kBlockSize) {
    const auto shape = static_cast<double>(std::min(kBlockSize, spacings - begin));
    const double sum = gammaVariate(shape, stream, static_cast<std::uint32_t>(begin / kBlockSize));
    begins_.push_back(begins_.back() + sum);
  }
  scale_ = total / begins_.back();
  largest_ = std::nextafter(total, 0.0);
}

std::int64_t SortedDraws::writeBlock(std::int64_t block, double* draws) const {
  const std::int64_t spacings = std::min(kBlockSize, count_ + 1 - block * kBlockSize);
  std::array<float, kBlockSize> spacing;
  const std::int64_t elements = std::min(kStretch, spacings);
  stream_.fillExponential4(static_cast<std::uint32_t>(block * kStretch), elements,
                           {spacing.data(), spacing.data() + kStretch,
                            spacing.data() + 2 * kStretch, spacing.data() + 3 * kStretch});
  std::array<double, kBlockSize> sums; // the last of them has no draw
  StretchSums before = prefixSums(spacing.data(), spacings, [&](std::int64_t index, double sum) {
    sums[std::size_t(index)] = sum;
  });
  double all = 0.0;
  for (double& sum : before) {
    all += std::exchange(sum, all);
  }
  const auto b = static_cast<std::size_t>(block);
  const double ratio = (begins_[b + 1] - begins_[b]) / all;
  const double limit = std::min(largest_, begins_[b + 1] * scale_);
  const std::int64_t length = std::min(kBlockSize, count_ - block * kBlockSize);
  for (std::int64_t begin = 0; begin < length; begin += kStretch) {
    const std::int64_t part = std::min(kStretch, length - begin);
    runKernel<PlaceKernel>(part, static_cast<const double*>(sums.data() + begin),
                           before[std::size_t(begin / kStretch)], ratio, begins_[b], scale_, limit,
                           draws + begin);
  }
  return length;
}

} // namespace dewpoint::filter
