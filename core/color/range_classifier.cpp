// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/range_classifier.h"

#include "core/base/vector_kernel.h"
#include "core/color/hsi.h"

#include <cmath>
#include <cstring>
#include <numbers>
#include <utility>

namespace dewpoint::color {
namespace {

constexpr double kSumOfWhite = 3.0 * 255.0;

} // namespace

RangeClassifier::RangeClassifier(const ColorRange& range)
    : sumMin_(std::max(1, int(std::ceil((range.intensityMin - kBoundSlack) * kSumOfWhite)))),
      sumMax_(int(std::floor((range.intensityMax + kBoundSlack) * kSumOfWhite))),
      // S = 1 - 3 min / sum, so the upper bound of S is the lower one of 3 min / sum.
      leastAbove_(RatioPlane::fromBound(1.0 - range.saturationMax - kBoundSlack, true)),
      leastBelow_(RatioPlane::fromBound(1.0 - range.saturationMin + kBoundSlack, false)) {
  // Widening both ends by the slack keeps all colors off the lines, and a range of a single hue
  // from being a whole line, which would take in the opposite hue.
  const double width = std::fmod(range.hueMax - range.hueMin + 720.0, 360.0) + 2.0 * kBoundSlack;
  hueRange_ = spansEveryHue(range) ? HueCombination::Every
              : width > 180.0      ? HueCombination::Either
                                   : HueCombination::Both;
  const double degree = std::numbers::pi / 180.0;
  const double low = (range.hueMin - kBoundSlack) * degree;
  const double high = (range.hueMax + kBoundSlack) * degree;
  fromMin_ = HuePlane::fromCoefficients(-std::sin(low), std::numbers::sqrt3 * std::cos(low));
  untilMax_ = HuePlane::fromCoefficients(std::sin(high), -std::numbers::sqrt3 * std::cos(high));
}

RangeClassifier::HuePlane RangeClassifier::HuePlane::fromCoefficients(double alongRed,
                                                                      double alongGreenBlue) {
  // The coefficients of B, G and R sum to zero, so each channel can be measured from a third one.
  // Measured from the middle coefficient's, the smallest is at most half the largest.
  const std::array<double, 3> coefficient{-alongRed - alongGreenBlue, -alongRed + alongGreenBlue,
                                          2.0 * alongRed};
  std::array<std::size_t, 3> channel{0, 1, 2};
  std::sort(channel.begin(), channel.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(coefficient[a]) < std::abs(coefficient[b]);
  });
  const auto [smallest, middle, largest] = channel;
  HuePlane plane{largest, middle, smallest, middle, {}};
  double slope = -coefficient[smallest] / std::abs(coefficient[largest]);
  if (coefficient[largest] < 0.0) {
    std::swap(plane.yPlus, plane.yMinus);
  }
  if (slope > 0.0) {
    std::swap(plane.xPlus, plane.xMinus);
    slope = -slope;
  }
  plane.line = hueLine(slope);
  return plane;
}

RangeClassifier::RatioPlane RangeClassifier::RatioPlane::fromBound(double bound, bool greater) {
  if (greater ? bound <= 0.0 : bound >= 1.0) {
    return {}; // no bound at all
  }
  // 3 min > bound * sum with sum = 3 min + excess: min > slope * excess.
  const double slope = bound / (3.0 * (1.0 - bound));
  if (slope < 1.0) {
    return {0, 1, ratioLine(slope, RatioAxes::LeastPerExcess), greater};
  }
  return {1, 0, ratioLine(1.0 / slope, RatioAxes::ExcessPerLeast), !greater};
}

/// How the channels of pixels side by side are taken apart.
struct PlainSplit {
  DEWPOINT_KERNEL void run(const std::uint8_t* __restrict pixels, int count,
                           std::int16_t* __restrict blue, std::int16_t* __restrict green,
                           std::int16_t* __restrict red) {
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      blue[i] = pixels[3 * i];
      green[i] = pixels[3 * i + 1];
      red[i] = pixels[3 * i + 2];
    }
  }
};

/// The same as whole registers of 32 bytes are best shuffled, which compilers do not find: bytes
/// stay within their half of it.
struct HalvesSplit {
  using Half = std::uint8_t __attribute__((vector_size(16)));
  using Bytes = std::uint8_t __attribute__((vector_size(32)));
  using Quarters = std::int64_t __attribute__((vector_size(32)));

  DEWPOINT_KERNEL void join(const Half& low, const Half& high, Bytes& whole) {
    whole = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15,
                                    16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31);
  }

  /// Sixteen pixels.
  DEWPOINT_KERNEL void split(const std::uint8_t* pixels, std::int16_t* blue, std::int16_t* green,
                             std::int16_t* red) {
    Half part[4]; // pixels 0 to 3; 4 to 7 from byte 4 on, so that nothing behind is read; and so on
    for (std::ptrdiff_t k = 0; k < 4; ++k) {
      std::memcpy(&part[k], pixels + 24 * (k / 2) + 8 * (k % 2), sizeof(Half));
    }
    const Bytes none{};
    Bytes first;
    Bytes second;
    join(part[0], part[2], first);
    join(part[1], part[3], second);
    // Four blues and four greens of each half, as numbers of 16 bits; 32 is a zero.
    const auto firstPairs = reinterpret_cast<Quarters>(__builtin_shufflevector(
        first, none, 0, 32, 3, 32, 6, 32, 9, 32, 1, 32, 4, 32, 7, 32, 10, 32, //
        16, 32, 19, 32, 22, 32, 25, 32, 17, 32, 20, 32, 23, 32, 26, 32));
    const auto secondPairs = reinterpret_cast<Quarters>(__builtin_shufflevector(
        second, none, 4, 32, 7, 32, 10, 32, 13, 32, 5, 32, 8, 32, 11, 32, 14, 32, //
        20, 32, 23, 32, 26, 32, 29, 32, 21, 32, 24, 32, 27, 32, 30, 32));
    const auto firstReds = __builtin_shufflevector(
        first, none, 2, 32, 5, 32, 8, 32, 11, 32, 32, 32, 32, 32, 32, 32, 32, 32, //
        18, 32, 21, 32, 24, 32, 27, 32, 32, 32, 32, 32, 32, 32, 32, 32);
    const auto secondReds = __builtin_shufflevector(
        second, none, 32, 32, 32, 32, 32, 32, 32, 32, 6, 32, 9, 32, 12, 32, 15, 32, //
        32, 32, 32, 32, 32, 32, 32, 32, 22, 32, 25, 32, 28, 32, 31, 32);
    const Quarters blues = __builtin_shufflevector(firstPairs, secondPairs, 0, 4, 2, 6);
    const Quarters greens = __builtin_shufflevector(firstPairs, secondPairs, 1, 5, 3, 7);
    const Bytes reds = firstReds | secondReds;
    std::memcpy(blue, &blues, sizeof(Bytes));
    std::memcpy(green, &greens, sizeof(Bytes));
    std::memcpy(red, &reds, sizeof(Bytes));
  }

  DEWPOINT_KERNEL void run(const std::uint8_t* pixels, int count, std::int16_t* blue,
                           std::int16_t* green, std::int16_t* red) {
    int i = 0;
    for (; i + 16 <= count; i += 16) {
      split(pixels + std::ptrdiff_t{3} * i, blue + i, green + i, red + i);
    }
    PlainSplit::run(pixels + std::ptrdiff_t{3} * i, count - i, blue + i, green + i, red + i);
  }
};

/// RangeClassifier::matches() for a row of pixels.
struct MatchRowKernel {
  using Hue = RangeClassifier::HueCombination;
  /// What a saturation bound compares.
  enum class Ratio { LeastOverExcess, ExcessOverLeast, None };

  /// The tests of matches() on 16-bit numbers, without a branch.
  /// Each test is a difference that is negative where the pixel passes, so that tests are joined by
  /// the bits of their signs.
  template <class Split, Hue Range, Ratio Below, Ratio Above> struct Kernel {
    static constexpr int kBlock = 1024; ///< pixels whose channels fit into the first-level cache
    using Planes = std::int16_t[3][kBlock]; ///< blue, green, red

    DEWPOINT_KERNEL std::int16_t highHalf(std::int32_t product) {
      return static_cast<std::int16_t>(product >> 16);
    }
    DEWPOINT_KERNEL std::int16_t both(std::int16_t a, std::int16_t b) {
      return static_cast<std::int16_t>(a & b);
    }

    struct HueTest {
      const std::int16_t* yPlus;
      const std::int16_t* yMinus;
      const std::int16_t* xPlus;
      const std::int16_t* xMinus;
      std::int16_t factor;

      HueTest(const RangeClassifier::HuePlane& plane, const Planes& planes)
          : yPlus(planes[plane.yPlus]), yMinus(planes[plane.yMinus]), xPlus(planes[plane.xPlus]),
            xMinus(planes[plane.xMinus]), factor(plane.line.scaledSlope) {}

      [[gnu::always_inline]] std::int16_t operator()(int i) const {
        const auto y = static_cast<std::int16_t>(yPlus[i] - yMinus[i]);
        const auto x = static_cast<std::int16_t>(xPlus[i] - xMinus[i]);
        return static_cast<std::int16_t>(highHalf(std::int32_t{x} * factor) - y);
      }
    };

    struct RatioTest {
      std::uint16_t factor;
      std::uint16_t scale;
      std::uint16_t flip; ///< d < 0 is asked, or d >= 0, which is ~d < 0

      explicit RatioTest(const RangeClassifier::RatioPlane& plane)
          : factor(plane.line.scaledSlope), scale(plane.line.scale),
            flip(plane.isAbove ? 0 : 0xFFFF) {}

      [[gnu::always_inline]] std::int16_t operator()(std::uint16_t y, std::uint16_t x) const {
        // Unsigned throughout: only so do compilers take the instruction for high halves.
        const auto height =
            static_cast<std::uint16_t>((std::uint32_t{x} * std::uint32_t{factor}) >> 16U);
        const auto scaled = static_cast<std::uint16_t>(scale * y);
        return static_cast<std::int16_t>(static_cast<std::uint16_t>(height - scaled) ^ flip);
      }
      template <Ratio Kind>
      [[gnu::always_inline]] std::int16_t of(std::uint16_t least, std::uint16_t excess) const {
        return Kind == Ratio::LeastOverExcess ? (*this)(least, excess) : (*this)(excess, least);
      }
    };

    DEWPOINT_KERNEL void decide(const RangeClassifier& classifier, const Planes& planes, int count,
                                std::uint8_t* __restrict out) {
      const RatioTest above(classifier.leastAbove_);
      const RatioTest below(classifier.leastBelow_);
      const HueTest fromMin(classifier.fromMin_, planes);
      const HueTest untilMax(classifier.untilMax_, planes);
      const auto tooLow = static_cast<std::int16_t>(classifier.sumMin_ - 1);
      const auto tooHigh = static_cast<std::int16_t>(classifier.sumMax_ + 1);
      for (int i = 0; i < count; ++i) {
        const std::int16_t b = planes[0][i];
        const std::int16_t g = planes[1][i];
        const std::int16_t r = planes[2][i];
        const std::int16_t blueGreen = b < g ? b : g;
        const std::int16_t least = blueGreen < r ? blueGreen : r;
        const auto sum = static_cast<std::int16_t>(b + g + r);
        const auto leastOf = static_cast<std::uint16_t>(least);
        const auto excess = static_cast<std::uint16_t>(sum - 3 * least);
        std::int16_t inside =
            both(static_cast<std::int16_t>(tooLow - sum), static_cast<std::int16_t>(sum - tooHigh));
        inside = both(inside, below.template of<Below>(leastOf, excess));
        if constexpr (Above != Ratio::None) {
          inside = both(inside, above.template of<Above>(leastOf, excess));
        }
        if constexpr (Range == Hue::Both) {
          inside = both(inside, both(fromMin(i), untilMax(i)));
        } else if constexpr (Range == Hue::Either) {
          inside = both(inside, static_cast<std::int16_t>(fromMin(i) | untilMax(i)));
        }
        out[i] = static_cast<std::uint8_t>(static_cast<std::int16_t>(inside >> 15));
      }
    }

    DEWPOINT_KERNEL void run(const RangeClassifier* classifier, const std::uint8_t* bgr,
                             std::int64_t count, std::uint8_t* out) {
      alignas(64) Planes planes;
      for (std::int64_t begin = 0; begin < count; begin += kBlock) {
        const int length = count - begin < kBlock ? static_cast<int>(count - begin) : kBlock;
        Split::run(bgr + 3 * begin, length, planes[0], planes[1], planes[2]);
        decide(*classifier, planes, length, out + begin);
      }
    }
  };

  /// Chooses the kernel: its kinds of tests are constants, nothing is chosen within its loops.
  const RangeClassifier* classifier;
  const std::uint8_t* bgr;
  std::int64_t count;
  std::uint8_t* out;

  static Ratio kindOf(const RangeClassifier::RatioPlane& plane) {
    const Ratio kind = plane.y == 0 ? Ratio::LeastOverExcess : Ratio::ExcessOverLeast;
    return plane.line.scale != 0 ? kind : Ratio::None;
  }
  template <Hue Range, Ratio Below, Ratio Above> void run() const {
#if defined(__x86_64__)
    if (instructionSet() == InstructionSet::Avx2) {
      return runKernelAvx2<Kernel<HalvesSplit, Range, Below, Above>>(classifier, bgr, count, out);
    }
#endif
    runKernel<Kernel<PlainSplit, Range, Below, Above>>(classifier, bgr, count, out);
  }
  template <Hue Range, Ratio Below> void withBelow() const {
    switch (kindOf(classifier->leastAbove_)) {
    case Ratio::LeastOverExcess:
      return run<Range, Below, Ratio::LeastOverExcess>();
    case Ratio::ExcessOverLeast:
      return run<Range, Below, Ratio::ExcessOverLeast>();
    case Ratio::None:
      return run<Range, Below, Ratio::None>();
    }
  }
  template <Hue Range> void withHue() const {
    if (kindOf(classifier->leastBelow_) == Ratio::ExcessOverLeast) {
      return withBelow<Range, Ratio::ExcessOverLeast>();
    }
    withBelow<Range, Ratio::LeastOverExcess>();
  }
  void choose() const {
    switch (classifier->hueRange_) {
    case Hue::Both:
      return withHue<Hue::Both>();
    case Hue::Either:
      return withHue<Hue::Either>();
    case Hue::Every:
      return withHue<Hue::Every>();
    }
  }
};

void RangeClassifier::matchRow(const std::uint8_t* bgr, std::int64_t count,
                               std::uint8_t* out) const noexcept {
  MatchRowKernel{this, bgr, count, out}.choose();
}

} // namespace dewpoint::color
