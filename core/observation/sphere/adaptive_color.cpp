// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/sphere/adaptive_color.h"

#include "core/color/hsi.h"
#include "core/observation/sphere/color_reach.h"

#include <algorithm>
#include <array>
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
constexpr double kFewestCounting = 0.7; ///< share of the pixels within
constexpr double kLowQuantile = 0.1;    ///< and its opposite: an odd tenth does not count
constexpr double kRingBegin = 1.35;     ///< radii: beyond the blurred rim
constexpr double kRingEnd = 2.0;        ///< radii
constexpr double kMostOfRing = 0.08;    ///< share that may match: a few stray pixels
constexpr int kRows = 120;              ///< rows of an image that are counted in an update
constexpr double kMostOfRest = 0.003;   ///< share that may match beyond twice that of before
constexpr double kRim = 1.15;           ///< radii: what is nearer may be the target's
constexpr double kTighter = 0.9;        ///< factor of one trial
constexpr double kTightest = 0.1;       ///< of the way from quantile to bound
constexpr double kWorthwhile = 0.002;   ///< F1 score: less is chance

using Pixel = cv::Vec3b;

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
  double initialMatchShareElsewhere() const { return restMatched / std::max(1.0, rest); }
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

AdaptiveColor::PerCamera AdaptiveColor::initialState(const ColorRanges& base) {
  PerCamera camera{.ranges = {}, .classifier = ColorClassifier(base)};
  for (const ColorRange& range : base) {
    camera.ranges.emplace_back(range);
  }
  return camera;
}

AdaptiveColor::AdaptiveColor(const ColorRanges& learned, std::size_t cameras)
    : learned_(learned), learnedClassifier_(std::make_shared<const ColorClassifier>(learned)),
      cameras_(cameras, initialState(learned)) {}

ColorRanges AdaptiveColor::rangesOf(const PerCamera& camera) {
  std::vector<ColorRange> ranges;
  ranges.reserve(camera.ranges.size());
  for (const FollowedRange& range : camera.ranges) {
    ranges.push_back(range.rangeInUse());
  }
  return ColorRanges(std::move(ranges));
}

ColorRanges AdaptiveColor::rangesInUse(std::size_t camera) const {
  return rangesOf(cameras_.at(camera));
}

std::vector<ColorRanges> AdaptiveColor::rangesInUse() const {
  std::vector<ColorRanges> ranges;
  ranges.reserve(cameras_.size());
  bool changed = false;
  for (const PerCamera& camera : cameras_) {
    ranges.push_back(rangesOf(camera));
    changed = changed || !(ranges.back() == learned_);
  }
  return changed ? ranges : std::vector<ColorRanges>{};
}

void AdaptiveColor::restoreLearnedRanges() {
  cameras_.assign(cameras_.size(), initialState(learned_));
}

namespace {

ColorRanges basesOf(const std::vector<FollowedRange>& ranges) {
  std::vector<ColorRange> bases;
  bases.reserve(ranges.size());
  for (const FollowedRange& range : ranges) {
    bases.push_back(range.initialRange());
  }
  return ColorRanges(std::move(bases));
}

} // namespace

void AdaptiveColor::undoAdaptation() {
  for (PerCamera& camera : cameras_) {
    camera = initialState(basesOf(camera.ranges));
  }
}

void AdaptiveColor::extendToLight(std::size_t index, const cv::Mat& image) {
  PerCamera& camera = cameras_.at(index);
  std::vector<ColorRange> bases;
  bases.reserve(learned_.size());
  for (const ColorRange& range : learned_) {
    bases.push_back(extendRangeToLight(range, image));
  }
  const ColorRanges base(std::move(bases));
  if (!(base == basesOf(camera.ranges))) {
    camera = initialState(base);
  }
}

bool AdaptiveColor::measure(const PerCamera& camera, const TargetImage& target,
                            Measured& measured) {
  std::vector<ColorRange> wider;
  for (const FollowedRange& range : camera.ranges) {
    wider.push_back(range.widened());
  }
  std::vector<std::array<std::vector<double>, 3>> values(camera.ranges.size());
  int all = 0;
  std::ptrdiff_t counting = 0;
  const double area = kInside * kInside * 3.2 * target.outline.radius * target.outline.radius;
  forDisc(target.image, target.outline, kInside, stepFor(area), [&](const Pixel& pixel) {
    ++all;
    const Hsi color = hsiFromBgr(pixel[0], pixel[1], pixel[2]);
    const auto own =
        std::ranges::find_if(wider, [&](const ColorRange& one) { return matches(color, one); });
    if (own != wider.end()) { // black does not match
      ++counting;
      const auto range = static_cast<std::size_t>(own - wider.begin());
      const auto place = camera.ranges[range].coordinatesOf(color);
      for (std::size_t k = 0; k < place.size(); ++k) {
        values[range][k].push_back(place[k]);
      }
    }
  });
  if (counting < kFewestSamples || static_cast<double>(counting) < kFewestCounting * all) {
    return false;
  }
  measured.assign(camera.ranges.size(), std::nullopt);
  for (std::size_t range = 0; range < values.size(); ++range) {
    if (std::ssize(values[range][0]) < kFewestSamples) {
      continue;
    }
    Quantiles own;
    for (std::size_t k = 0; k < values[range].size(); ++k) {
      std::tie(own[2 * k], own[2 * k + 1]) = quantiles(values[range][k]);
    }
    measured[range] = own;
  }
  return true;
}

std::optional<double> AdaptiveColor::step(PerCamera& camera, const TargetImage& target,
                                          const Measured& next) {
  std::vector<ColorRange> ranges;
  for (std::size_t k = 0; k < camera.ranges.size(); ++k) {
    ranges.push_back(next[k] ? camera.ranges[k].at(*next[k]) : camera.ranges[k].rangeInUse());
    if (!FollowedRange::isUsable(ranges.back())) {
      return std::nullopt;
    }
  }
  const ColorClassifier classifier{ColorRanges(std::move(ranges))};
  const Counts before = target.count(camera.classifier);
  const Counts after = target.count(classifier);
  if (after.ringShare() > std::max(kMostOfRing, before.ringShare()) ||
      after.initialMatchShareElsewhere() >
          std::max(2.0 * camera.initialMatchShareElsewhere + kMostOfRest,
                   before.initialMatchShareElsewhere())) {
    return std::nullopt;
  }
  for (std::size_t k = 0; k < camera.ranges.size(); ++k) {
    if (next[k]) {
      camera.ranges[k].moveTo(*next[k]);
    }
  }
  camera.classifier = classifier;
  return after.f1();
}

void AdaptiveColor::tighten(PerCamera& camera, const TargetImage& target, double f1) {
  const std::size_t turn = static_cast<std::size_t>(camera.updateCount) %
                           (FollowedRange::kBoundCount * camera.ranges.size());
  const std::size_t bound = turn % FollowedRange::kBoundCount;
  const std::size_t own = turn / FollowedRange::kBoundCount;
  FollowedRange& range = camera.ranges[own];
  const ColorRanges inUse = rangesOf(camera);
  double best = f1 + kWorthwhile;
  const double before = range.slack(bound);
  double chosen = before;
  for (const double tried :
       {std::max(kTightest, before * kTighter), std::min(1.0, before / kTighter)}) {
    std::vector<ColorRange> ranges(inUse.begin(), inUse.end());
    ranges[own] = range.withSlack(bound, tried);
    const double now = target.count(ColorClassifier{ColorRanges(std::move(ranges))}).f1();
    if (now > best) {
      best = now;
      chosen = tried;
    }
  }
  if (chosen != before) {
    range.setSlack(bound, chosen);
    camera.classifier = ColorClassifier(rangesOf(camera));
  }
}

bool AdaptiveColor::adapt(std::size_t index, const cv::Mat& image, const SphereImage& outline,
                          const std::vector<SphereImage>& others, double share) {
  PerCamera& camera = cameras_.at(index);
  const TargetImage target{image, outline, others, camera.updateCount};
  Measured measured;
  if (image.type() != CV_8UC3 || !measure(camera, target, measured)) {
    return false;
  }
  ++camera.updateCount;
  if (camera.updateCount <= kReferenceUpdateCount) {
    const double ofThis = 1.0 / camera.updateCount;
    camera.initialMatchShareElsewhere +=
        ofThis * (target.count(camera.classifier).initialMatchShareElsewhere() -
                  camera.initialMatchShareElsewhere);
  }
  bool moves = false;
  for (std::size_t k = 0; k < measured.size(); ++k) {
    FollowedRange& range = camera.ranges[k];
    if (measured[k] && range.addReference(*measured[k], kReferenceUpdateCount)) {
      measured[k].reset();
    } else if (measured[k]) {
      measured[k] = range.toward(*measured[k], share);
      moves = true;
    }
  }
  if (!moves) {
    return false;
  }
  const auto f1 = step(camera, target, measured);
  if (f1) {
    tighten(camera, target, *f1);
  }
  return f1.has_value();
}

} // namespace dewpoint::observation
