// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/vector_kernel.h"
#include "core/color/color_classifier.h"

namespace dewpoint {

/// ColorClassifier::matches() for many pixels: the same tests on 16-bit numbers, without a branch.
struct MatchRowKernel {
  static constexpr int kBlock = 512; ///< pixels whose channels fit into the first-level cache
  using Hue = ColorClassifier::HueRange;

  /// Channels and what is derived from them, each on its own.
  struct Planes {
    std::int16_t bgr[3][kBlock];
    std::uint16_t leastAndExcess[2][kBlock];
    std::int16_t sumMatches[kBlock]; ///< all bits or none, like the answer of every test here
  };

  DEWPOINT_KERNEL std::int16_t highHalf(std::int32_t product) {
    return static_cast<std::int16_t>(product >> 16);
  }

  DEWPOINT_KERNEL std::int16_t allBits(bool yes) { return static_cast<std::int16_t>(yes ? -1 : 0); }

  DEWPOINT_KERNEL void split(const std::uint8_t* __restrict pixels, int count, Planes& planes) {
    for (std::ptrdiff_t i = 0; i < count; ++i) {
      planes.bgr[0][i] = pixels[3 * i];
      planes.bgr[1][i] = pixels[3 * i + 1];
      planes.bgr[2][i] = pixels[3 * i + 2];
    }
  }

  DEWPOINT_KERNEL void derive(int sumMin, int sumMax, int count, Planes& planes) {
    const auto low = static_cast<std::int16_t>(sumMin);
    const auto high = static_cast<std::int16_t>(sumMax);
    for (int i = 0; i < count; ++i) {
      const std::int16_t b = planes.bgr[0][i];
      const std::int16_t g = planes.bgr[1][i];
      const std::int16_t r = planes.bgr[2][i];
      const std::int16_t blueGreen = b < g ? b : g;
      const std::int16_t least = blueGreen < r ? blueGreen : r;
      const auto sum = static_cast<std::int16_t>(b + g + r);
      planes.leastAndExcess[0][i] = static_cast<std::uint16_t>(least);
      planes.leastAndExcess[1][i] = static_cast<std::uint16_t>(sum - 3 * least);
      planes.sumMatches[i] = static_cast<std::int16_t>(allBits(sum >= low) & allBits(sum <= high));
    }
  }

  /// Positive where the pixel is on the plane's side, for the i-th pixel.
  struct HueTest {
    const std::int16_t* yPlus;
    const std::int16_t* yMinus;
    const std::int16_t* xPlus;
    const std::int16_t* xMinus;
    std::int16_t factor;

    HueTest(const ColorClassifier::HuePlane& plane, const Planes& planes)
        : yPlus(planes.bgr[plane.yPlus]), yMinus(planes.bgr[plane.yMinus]),
          xPlus(planes.bgr[plane.xPlus]), xMinus(planes.bgr[plane.xMinus]),
          factor(plane.line.factor) {}

    [[gnu::always_inline]] std::int16_t operator()(int i) const {
      const auto y = static_cast<std::int16_t>(yPlus[i] - yMinus[i]);
      const auto x = static_cast<std::int16_t>(xPlus[i] - xMinus[i]);
      return allBits(y > highHalf(std::int32_t{x} * factor));
    }
  };

  struct RatioTest {
    const std::uint16_t* y;
    const std::uint16_t* x;
    std::uint16_t factor;
    std::uint16_t scale;
    /// d > 0 is asked, or d <= 0, which is ~d > -2.
    std::int16_t flip;
    std::int16_t bound;

    RatioTest(const ColorClassifier::RatioPlane& plane, const Planes& planes)
        : y(planes.leastAndExcess[plane.y]), x(planes.leastAndExcess[plane.x]),
          factor(plane.line.factor), scale(plane.line.scale), flip(plane.above ? 0 : -1),
          bound(plane.above ? 0 : -2) {}

    [[gnu::always_inline]] std::int16_t operator()(int i) const {
      // Unsigned throughout: only so do compilers take the instruction for high halves.
      const auto height =
          static_cast<std::uint16_t>((std::uint32_t{x[i]} * std::uint32_t{factor}) >> 16U);
      const auto scaled = static_cast<std::uint16_t>(scale * y[i]);
      const auto difference =
          static_cast<std::int16_t>(static_cast<std::uint16_t>(scaled - height));
      return allBits(static_cast<std::int16_t>(difference ^ flip) > bound);
    }
  };

  template <Hue Range>
  DEWPOINT_KERNEL void decide(const ColorClassifier& classifier, const Planes& planes, int count,
                              std::uint8_t* __restrict out) {
    const RatioTest above(classifier.leastAbove_, planes);
    const RatioTest below(classifier.leastBelow_, planes);
    const HueTest fromMin(classifier.fromMin_, planes);
    const HueTest untilMax(classifier.untilMax_, planes);
    for (int i = 0; i < count; ++i) {
      int inside = above(i) & below(i) & planes.sumMatches[i];
      if constexpr (Range == Hue::Both) {
        inside = inside & (fromMin(i) & untilMax(i));
      } else if constexpr (Range == Hue::Either) {
        inside = inside & (fromMin(i) | untilMax(i));
      }
      out[i] = static_cast<std::uint8_t>(inside);
    }
  }

  DEWPOINT_KERNEL void run(const ColorClassifier* classifier, const std::uint8_t* bgr,
                           std::int64_t count, std::uint8_t* out) {
    alignas(64) Planes planes;
    for (std::int64_t begin = 0; begin < count; begin += kBlock) {
      const int length = count - begin < kBlock ? static_cast<int>(count - begin) : kBlock;
      split(bgr + 3 * begin, length, planes);
      derive(classifier->sumMin_, classifier->sumMax_, length, planes);
      switch (classifier->hueRange_) {
      case Hue::Both:
        decide<Hue::Both>(*classifier, planes, length, out + begin);
        break;
      case Hue::Either:
        decide<Hue::Either>(*classifier, planes, length, out + begin);
        break;
      case Hue::Every:
        decide<Hue::Every>(*classifier, planes, length, out + begin);
        break;
      }
    }
  }
};

void ColorClassifier::matchRow(const std::uint8_t* bgr, std::int64_t count,
                               std::uint8_t* out) const noexcept {
  runKernel<MatchRowKernel>(this, bgr, count, out);
}

} // namespace dewpoint
