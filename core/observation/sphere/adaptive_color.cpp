// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/sphere/adaptive_color.h"

#include "core/color/hsi.h"
#include "core/observation/sphere/color_reach.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace dewpoint::observation {
namespace {

// Reasons: docs/method-dewpoint.md, section 8; those without a derivation are judgments.

/// Radii; inside lies neither the blurred rim nor a small error of the position.
constexpr double kInside = 0.85;
constexpr int kMostSamples = 400; ///< of the target, and as many of its ring
constexpr int kFewestSamples = 20;
/// A color counts as the target's when it is in the range in use, widened by so much: what hides a
/// part of it is left out.
constexpr double kWiderHue = 12.0; // degrees
constexpr double kWiderSaturation = 0.12;
constexpr double kWiderIntensity = 1.35;  ///< factor
constexpr double kFewestCounting = 0.7;   ///< share of the pixels within
constexpr double kLowQuantile = 0.1;      ///< and its opposite: an odd tenth does not count
constexpr double kRingBegin = 1.35;       ///< radii: beyond the blurred rim
constexpr double kRingEnd = 2.0;          ///< radii
constexpr double kMostOfRing = 0.08;      ///< share that may match: a few stray pixels
constexpr int kRows = 120;                ///< rows of an image that are counted in an update
constexpr double kMostOfRest = 0.003;     ///< share that may match beyond twice that of before
constexpr double kRim = 1.15;             ///< radii: what is nearer may be the target's
constexpr double kMostHue = 30.0;         ///< degrees from what was learned
constexpr double kMostSaturation = 0.35;  ///< from what was learned
constexpr double kMostIntensity = 2.0794; ///< ln 8
constexpr double kNarrowest = 1e-3;
constexpr double kTighter = 0.9;      ///< factor of one trial
constexpr double kTightest = 0.1;     ///< of the way from quantile to bound
constexpr double kWorthwhile = 0.002; ///< F1 score: less is chance

using Pixel = cv::Vec3b;

/// `angle` within [-180, 180), degrees.
double aside(double angle) {
  return angle - 360.0 * std::floor((angle + 180.0) / 360.0);
}
double widthOf(const ColorRange& range) {
  return spansEveryHue(range) ? 360.0 : hueOf(range.hueMax - range.hueMin);
}

/// The range with both hue bounds, the saturation's and the intensity's farther out.
ColorRange widened(ColorRange range) {
  if (widthOf(range) + 2.0 * kWiderHue >= 360.0) {
    range.hueMin = 0.0;
    range.hueMax = 360.0;
  } else {
    range.hueMin = hueOf(range.hueMin - kWiderHue);
    range.hueMax = hueOf(range.hueMax + kWiderHue);
  }
  range.saturationMin = std::max(0.0, range.saturationMin - kWiderSaturation);
  range.saturationMax = std::min(1.0, range.saturationMax + kWiderSaturation);
  range.intensityMin /= kWiderIntensity;
  range.intensityMax = std::min(1.0, range.intensityMax * kWiderIntensity);
  return range;
}

/// The columns of a row that lie within a circle: [first, last).
struct Stretch {
  int first = 0, last = 0;
  int length() const { return last - first; }
};
Stretch stretchOf(const SphereImage& circle, double radii, int row, int columns) {
  const double radius = radii * circle.radius;
  const double above = row - circle.center.y();
  const double half = radius * radius - above * above;
  if (!(half > 0.0)) {
    return {};
  }
  const auto bounded = [&](double value) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(columns)));
  };
  const double wide = std::sqrt(half);
  return {bounded(std::ceil(circle.center.x() - wide)),
          bounded(std::floor(circle.center.x() + wide) + 1.0)};
}

/// Calls `use` with the pixels within some radii of an outline, every `step`-th of both ways.
template <class Use>
void forDisc(const cv::Mat& image, const SphereImage& outline, double radii, int step,
             const Use& use) {
  const double reach = radii * outline.radius;
  const auto bounded = [&](double value) {
    return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(image.rows)));
  };
  const int bottom = bounded(std::floor(outline.center.y() + reach) + 1.0);
  for (int row = bounded(std::ceil(outline.center.y() - reach)); row < bottom; row += step) {
    const Stretch stretch = stretchOf(outline, radii, row, image.cols);
    for (int column = stretch.first; column < stretch.last; column += step) {
      use(image.at<Pixel>(row, column));
    }
  }
}

bool isUsable(const ColorRange& range) {
  return range.saturationMin + kNarrowest <= range.saturationMax &&
         range.intensityMin + kNarrowest <= range.intensityMax &&
         checkColorRange(range).has_value();
}

/// Step that leaves about kMostSamples pixels of an area.
int stepFor(double area) {
  return std::max(1, static_cast<int>(std::ceil(std::sqrt(area / kMostSamples))));
}

/// Pixels of the target, of the ring around it and of the rest of the image, the ring included; and
/// those that match.
struct Counts {
  double target = 0.0, ring = 0.0, rest = 0.0;
  double targetMatched = 0.0, ringMatched = 0.0, restMatched = 0.0;
  double f1() const {
    return 2.0 * targetMatched / std::max(1.0, target + targetMatched + restMatched);
  }
  double ringShare() const { return ringMatched / std::max(1.0, ring); }
  double restShare() const { return restMatched / std::max(1.0, rest); }
};

} // namespace

/// The target in one image.
struct AdaptiveColor::TargetImage {
  const cv::Mat& image;
  const SphereImage& outline;
  const std::vector<SphereImage>& others;
  int phase = 0; ///< which rows are counted

  void addRow(int row, const ColorClassifier& classifier, std::vector<std::uint8_t>& match,
              Counts& counts) const;
  Counts count(const ColorClassifier& classifier) const;
};

void AdaptiveColor::TargetImage::addRow(int row, const ColorClassifier& classifier,
                                        std::vector<std::uint8_t>& match, Counts& counts) const {
  classifier.matchRow(image.ptr<std::uint8_t>(row), image.cols, match.data());
  const auto matched = [&](const Stretch& stretch) {
    return static_cast<double>(
        std::count(match.begin() + stretch.first, match.begin() + stretch.last, 255));
  };
  const auto clear = [&](const Stretch& stretch) {
    std::fill(match.begin() + stretch.first, match.begin() + stretch.last, std::uint8_t{0});
    return stretch.length();
  };
  counts.rest += image.cols;
  for (const SphereImage& other : others) {
    counts.rest -= clear(stretchOf(other, kRingBegin, row, image.cols));
  }
  const Stretch target = stretchOf(outline, 1.0, row, image.cols);
  const Stretch inner = stretchOf(outline, kRingBegin, row, image.cols);
  const Stretch outer = stretchOf(outline, kRingEnd, row, image.cols);
  counts.target += target.length();
  counts.targetMatched += matched(target);
  counts.ring += outer.length() - inner.length();
  counts.ringMatched += matched(outer) - matched(inner);
  counts.rest -= clear(stretchOf(outline, kRim, row, image.cols));
  counts.restMatched += matched({0, image.cols});
}

Counts AdaptiveColor::TargetImage::count(const ColorClassifier& classifier) const {
  const int step = std::max(1, image.rows / kRows);
  std::vector<std::uint8_t> match(static_cast<std::size_t>(image.cols));
  Counts counts;
  for (int row = phase % step; row < image.rows; row += step) {
    addRow(row, classifier, match, counts);
  }
  return counts;
}

namespace {

/// The values at kLowQuantile from both ends. Not quantile(): that is linear between two values and
/// needs all of them sorted; here one that occurs is enough, in each frame.
std::pair<double, double> quantiles(std::vector<double>& values) {
  const auto last = std::ssize(values) - 1;
  const auto at = [&](double share) {
    const auto nth = values.begin() + std::lround(share * static_cast<double>(last));
    std::nth_element(values.begin(), nth, values.end());
    return *nth;
  };
  const double low = at(kLowQuantile);
  return {low, at(1.0 - kLowQuantile)};
}

} // namespace

AdaptiveColor::AdaptiveColor(const ColorRange& learned, std::size_t cameras)
    : learned_(learned), learnedClassifier_(std::make_shared<const ColorClassifier>(learned)),
      cameras_(cameras,
               PerCamera{.base = learned, .range = learned, .classifier = *learnedClassifier_}) {}

std::vector<ColorRange> AdaptiveColor::rangesInUse() const {
  std::vector<ColorRange> ranges;
  ranges.reserve(cameras_.size());
  bool changed = false;
  for (const PerCamera& camera : cameras_) {
    ranges.push_back(camera.range);
    changed = changed || !(camera.range == learned_);
  }
  return changed ? ranges : std::vector<ColorRange>{};
}

void AdaptiveColor::forget() {
  cameras_.assign(
      cameras_.size(),
      PerCamera{.base = learned_, .range = learned_, .classifier = *learnedClassifier_});
}

void AdaptiveColor::undoFollowing() {
  for (PerCamera& camera : cameras_) {
    camera = PerCamera{
        .base = camera.base, .range = camera.base, .classifier = ColorClassifier(camera.base)};
  }
}

void AdaptiveColor::reach(std::size_t index, const cv::Mat& image) {
  PerCamera& camera = cameras_.at(index);
  const ColorRange base = reachInLight(learned_, image);
  if (!(base == camera.base)) {
    camera = PerCamera{.base = base, .range = base, .classifier = ColorClassifier(base)};
  }
}

double AdaptiveColor::hueCenter(const ColorRange& range) {
  return range.hueMin + 0.5 * widthOf(range);
}

AdaptiveColor::Quantiles AdaptiveColor::boundsOf(const ColorRange& range) {
  const double half = 0.5 * widthOf(range);
  return {-half,
          half,
          range.saturationMin,
          range.saturationMax,
          std::log(range.intensityMin),
          std::log(range.intensityMax)}; // of 0: no bound, see rangeOf()
}

bool AdaptiveColor::measure(const PerCamera& camera, const TargetImage& target,
                            Quantiles& measured) const {
  const ColorRange wider = widened(camera.range);
  const double center = hueCenter(camera.base);
  std::array<std::vector<double>, 3> values;
  int all = 0;
  const double area = kInside * kInside * 3.2 * target.outline.radius * target.outline.radius;
  forDisc(target.image, target.outline, kInside, stepFor(area), [&](const Pixel& pixel) {
    ++all;
    const Hsi color = hsiFromBgr(pixel[0], pixel[1], pixel[2]);
    if (matches(color, wider)) {
      values[0].push_back(std::isnan(color.hueDegrees) ? 0.0 : aside(color.hueDegrees - center));
      values[1].push_back(color.saturation);
      values[2].push_back(std::log(color.intensity)); // black does not match
    }
  });
  const auto counting = std::ssize(values[0]);
  if (counting < kFewestSamples || static_cast<double>(counting) < kFewestCounting * all) {
    return false;
  }
  for (std::size_t k = 0; k < values.size(); ++k) {
    std::tie(measured[2 * k], measured[2 * k + 1]) = quantiles(values[k]);
  }
  return true;
}

ColorRange AdaptiveColor::rangeOf(const PerCamera& camera, const Quantiles& now,
                                  const Quantiles& slack) const {
  static constexpr Quantiles kMost{kMostHue,        kMostHue,       kMostSaturation,
                                   kMostSaturation, kMostIntensity, kMostIntensity};
  Quantiles bounds = boundsOf(camera.base);
  for (std::size_t k = 0; k < kBounds; ++k) {
    const double outward = k % 2 == 0 ? -1.0 : 1.0;
    const double way = bounds[k] - camera.reference[k];
    const double kept = outward * way > 0.0 ? slack[k] * way : way;
    const double moved = std::clamp(now[k] - camera.reference[k], -kMost[k], kMost[k]);
    bounds[k] = camera.reference[k] + moved + kept;
  }
  ColorRange range = camera.base; // a bound that is no bound stays none
  if (!spansEveryHue(camera.base)) {
    range.hueMin = hueOf(hueCenter(camera.base) + bounds[0]);
    range.hueMax =
        hueOf(hueCenter(camera.base) + std::max(bounds[0], std::min(bounds[1], bounds[0] + 350.0)));
  }
  if (camera.base.saturationMin > 0.0) {
    range.saturationMin = std::clamp(bounds[2], 0.0, 1.0);
  }
  if (camera.base.saturationMax < 1.0) {
    range.saturationMax = std::clamp(bounds[3], 0.0, 1.0);
  }
  if (camera.base.intensityMin > 0.0) {
    range.intensityMin = std::min(1.0, std::exp(bounds[4]));
  }
  if (camera.base.intensityMax < 1.0) {
    range.intensityMax = std::min(1.0, std::exp(bounds[5]));
  }
  return range;
}

void AdaptiveColor::begin(PerCamera& camera, const TargetImage& target,
                          const Quantiles& measured) const {
  const double share = 1.0 / camera.updateCount;
  for (std::size_t k = 0; k < kBounds; ++k) {
    camera.reference[k] += share * (measured[k] - camera.reference[k]);
  }
  camera.restShare += share * (target.count(camera.classifier).restShare() - camera.restShare);
  camera.now = camera.reference;
}

std::optional<double> AdaptiveColor::step(PerCamera& camera, const TargetImage& target,
                                          const Quantiles& next) const {
  const ColorRange range = rangeOf(camera, next, camera.slack);
  if (!isUsable(range)) {
    return std::nullopt;
  }
  const ColorClassifier classifier(range);
  const Counts before = target.count(camera.classifier);
  const Counts after = target.count(classifier);
  if (after.ringShare() > std::max(kMostOfRing, before.ringShare()) ||
      after.restShare() > std::max(2.0 * camera.restShare + kMostOfRest, before.restShare())) {
    return std::nullopt;
  }
  camera.now = next;
  camera.range = range;
  camera.classifier = classifier;
  return after.f1();
}

void AdaptiveColor::tighten(PerCamera& camera, const TargetImage& target, double f1) const {
  const std::size_t bound = static_cast<std::size_t>(camera.updateCount) % kBounds;
  double best = f1 + kWorthwhile;
  const double before = camera.slack[bound];
  for (const double tried :
       {std::max(kTightest, before * kTighter), std::min(1.0, before / kTighter)}) {
    Quantiles slack = camera.slack;
    slack[bound] = tried;
    const ColorRange range = rangeOf(camera, camera.now, slack);
    const ColorClassifier classifier(isUsable(range) ? range : camera.range);
    const double now = target.count(classifier).f1();
    if (now > best) {
      best = now;
      camera.slack[bound] = tried;
    }
  }
  if (camera.slack[bound] != before) {
    camera.range = rangeOf(camera, camera.now, camera.slack);
    camera.classifier = ColorClassifier(camera.range);
  }
}

bool AdaptiveColor::follow(std::size_t index, const cv::Mat& image, const SphereImage& outline,
                           const std::vector<SphereImage>& others, double share) {
  PerCamera& camera = cameras_.at(index);
  const TargetImage target{image, outline, others, camera.updateCount};
  Quantiles measured;
  if (image.type() != CV_8UC3 || !measure(camera, target, measured)) {
    return false;
  }
  ++camera.updateCount;
  if (camera.updateCount <= kReferenceUpdates) {
    begin(camera, target, measured);
    return false;
  }
  Quantiles next;
  for (std::size_t k = 0; k < kBounds; ++k) {
    next[k] = camera.now[k] + share * (measured[k] - camera.now[k]);
  }
  const auto f1 = step(camera, target, next);
  if (f1) {
    tighten(camera, target, *f1);
  }
  return f1.has_value();
}

} // namespace dewpoint::observation
