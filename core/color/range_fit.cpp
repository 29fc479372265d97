// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/range_fit.h"

#include "core/base/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace dewpoint::color {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Bins of one degree.
constexpr int kHues = 360;
/// Bins of one hundredth, 0 and 1 included.
constexpr int kHundredths = 101;
/// Rounds over the six bounds, at most.
constexpr int kRounds = 12;
/// What it must be better to let every hue through: objects not in these images have other hues.
constexpr double kWorthEveryHue = 0.02;
/// F1 scores nearer than this are of the same colors, summed in another order.
constexpr double kRounding = 1e-12;
/// Bins have their middle on whole numbers, bounds lie half a bin beyond.
constexpr double kHalfBin = 0.5;

enum class Axis { Hue, Saturation, Intensity };

/// Weights of both sides along one axis, of the colors that the other two axes let through.
struct Profile {
  std::vector<double> target, rest;
  double targetGray = 0.0, restGray = 0.0; ///< without a hue; on the hue axis only
};

/// The interval that is best on one axis: `length` bins from `first` on, circular for the hue.
struct Interval {
  int first = 0, length = 0;
  double f1 = -1.0;
};

int binOf(Axis axis, const Hsi& color) {
  switch (axis) {
  case Axis::Hue:
    return static_cast<int>(std::lround(color.hueDegrees)) % kHues;
  case Axis::Saturation:
    return static_cast<int>(std::lround(inPercent(color.saturation)));
  case Axis::Intensity:
    break;
  }
  return static_cast<int>(std::lround(inPercent(color.intensity)));
}

void openAxis(Axis axis, ColorRange& range) {
  switch (axis) {
  case Axis::Hue:
    range.hueMin = 0.0;
    range.hueMax = 360.0;
    break;
  case Axis::Saturation:
    range.saturationMin = 0.0;
    range.saturationMax = 1.0;
    break;
  case Axis::Intensity:
    range.intensityMin = 0.0;
    range.intensityMax = 1.0;
    break;
  }
}

void count(Axis axis, const ColorRange& open, const std::vector<WeightedHsiColor>& colors,
           std::vector<double>& bins, double& gray) {
  bins.assign(axis == Axis::Hue ? kHues : kHundredths, 0.0);
  for (const WeightedHsiColor& cell : colors) {
    if (!matches(cell.color, open)) {
      continue;
    }
    if (axis == Axis::Hue && std::isnan(cell.color.hueDegrees)) {
      gray += cell.weight;
    } else {
      bins[std::size_t(binOf(axis, cell.color))] += cell.weight;
    }
  }
}

double f1Score(double target, double rest, double all) {
  return 2.0 * target / (all + target + rest);
}

/// Calls `visit` with each interval that begins where the target has a color; of equal beginnings
/// the shorter first.
template <class Visit>
void forEachInterval(const Profile& profile, bool circular, double all, Visit visit) {
  const int bins = static_cast<int>(profile.target.size());
  for (int first = 0; first < bins; ++first) {
    if (profile.target[std::size_t(first)] <= 0.0) {
      continue; // a bin without the target is no end of the best interval
    }
    double target = 0.0;
    double rest = 0.0;
    const int longest = circular ? bins - 1 : bins - first;
    for (int length = 1; length <= longest; ++length) {
      const auto bin = std::size_t((first + length - 1) % bins);
      target += profile.target[bin];
      rest += profile.rest[bin];
      visit(Interval{first, length, f1Score(target, rest, all)});
    }
  }
}

/// Every interval is tried; of equal ones the first found, that is the shortest from its start.
Interval bestInterval(const Profile& profile, bool circular, double all) {
  Interval best;
  forEachInterval(profile, circular, all, [&](const Interval& interval) {
    if (interval.f1 > best.f1) {
      best = interval;
    }
  });
  return best;
}

void setAxis(Axis axis, const Interval& interval, ColorRange& range) {
  const double low = interval.first - kHalfBin;
  const double high = interval.first + interval.length - 1 + kHalfBin;
  switch (axis) {
  case Axis::Hue:
    range.hueMin = std::fmod(low + kHues, kHues);
    range.hueMax = std::fmod(high + kHues, kHues);
    break;
  case Axis::Saturation:
    range.saturationMin = std::max(0.0, low / 100.0);
    range.saturationMax = std::min(1.0, high / 100.0);
    break;
  case Axis::Intensity:
    range.intensityMin = std::max(0.0, low / 100.0);
    range.intensityMax = std::min(1.0, high / 100.0);
    break;
  }
}

/// One axis is made the best for the other two; the F1 score after it.
double improve(Axis axis, const std::vector<WeightedHsiColor>& target,
               const std::vector<WeightedHsiColor>& rest, double all, ColorRange& range) {
  ColorRange open = range;
  openAxis(axis, open);
  Profile profile;
  count(axis, open, target, profile.target, profile.targetGray);
  count(axis, open, rest, profile.rest, profile.restGray);
  const Interval best = bestInterval(profile, axis == Axis::Hue, all);
  if (axis == Axis::Hue) {
    const RangeScore every = scoreRange(open, target, rest);
    if (every.f1 > best.f1 + kWorthEveryHue) {
      range = open;
      return every.f1;
    }
  }
  if (best.length > 0) {
    setAxis(axis, best, range);
  }
  return best.f1;
}

/// The middle of the target's colors on one axis, with `tail` of the weight left out on each side.
Interval quantiles(const std::vector<double>& bins, int first, double tail) {
  const int size = static_cast<int>(bins.size());
  double all = 0.0;
  for (const double weight : bins) {
    all += weight;
  }
  Interval interval{first, 1, 0.0};
  double sum = 0.0;
  int begin = -1;
  for (int i = 0; i < size; ++i) {
    sum += bins[std::size_t((first + i) % size)];
    if (begin < 0 && sum > tail * all) {
      begin = i;
      interval.first = (first + i) % size;
    }
    if (begin >= 0) {
      interval.length = i - begin + 1;
      if (sum >= (1.0 - tail) * all) {
        break;
      }
    }
  }
  return interval;
}

/// Where the hues are cut open to be put in order: opposite to their mean direction.
int oppositeHue(const std::vector<double>& bins) {
  double x = 0.0;
  double y = 0.0;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    x += bins[i] * std::cos(double(i) * std::numbers::pi / 180.0);
    y += bins[i] * std::sin(double(i) * std::numbers::pi / 180.0);
  }
  const double opposite = radiansToHueDegrees(std::atan2(-y, -x));
  return (static_cast<int>(std::lround(opposite)) + kHues) % kHues;
}

ColorRange quantileBox(const std::vector<WeightedHsiColor>& target, double tail) {
  ColorRange range{0.0, 360.0};
  const ColorRange open = range;
  double gray = 0.0;
  std::vector<double> bins;
  count(Axis::Hue, open, target, bins, gray);
  if (const Interval hue = quantiles(bins, oppositeHue(bins), tail); hue.length < kHues) {
    setAxis(Axis::Hue, hue, range);
  }
  count(Axis::Saturation, open, target, bins, gray);
  setAxis(Axis::Saturation, quantiles(bins, 0, tail), range);
  count(Axis::Intensity, open, target, bins, gray);
  setAxis(Axis::Intensity, quantiles(bins, 0, tail), range);
  return range;
}

} // namespace

RangeScore scoreRange(const ColorRanges& ranges, const std::vector<WeightedHsiColor>& target,
                      const std::vector<WeightedHsiColor>& rest) {
  RangeScore score;
  double all = 0.0;
  for (const WeightedHsiColor& cell : target) {
    all += cell.weight;
    score.targetWeight += matches(cell.color, ranges) ? cell.weight : 0.0;
  }
  for (const WeightedHsiColor& cell : rest) {
    score.restWeight += matches(cell.color, ranges) ? cell.weight : 0.0;
  }
  score.f1 = all > 0.0 ? f1Score(score.targetWeight, score.restWeight, all) : 0.0;
  return score;
}

ColorRange fitRange(const std::vector<WeightedHsiColor>& target,
                    const std::vector<WeightedHsiColor>& rest) {
  double all = 0.0;
  for (const WeightedHsiColor& cell : target) {
    all += cell.weight;
  }
  ColorRange best;
  double bestF1 = -1.0;
  for (const double tail : {0.02, 0.1, 0.25}) {
    ColorRange range = quantileBox(target, tail);
    double before = -1.0;
    for (int round = 0; round < kRounds; ++round) {
      double f1 = 0.0;
      for (const Axis axis : {Axis::Hue, Axis::Saturation, Axis::Intensity}) {
        f1 = improve(axis, target, rest, all, range);
      }
      if (f1 <= before) {
        break;
      }
      before = f1;
    }
    if (before > bestF1) {
      bestF1 = before;
      best = range;
    }
  }
  return best;
}

ColorRange withNarrowestHue(const ColorRange& range, const std::vector<WeightedHsiColor>& target,
                            const std::vector<WeightedHsiColor>& rest) {
  ColorRange open = range;
  openAxis(Axis::Hue, open);
  if (range == open) {
    return range; // every hue on purpose: see kWorthEveryHue
  }
  Profile profile;
  count(Axis::Hue, open, target, profile.target, profile.targetGray);
  count(Axis::Hue, open, rest, profile.rest, profile.restGray);
  double all = 0.0;
  for (const WeightedHsiColor& cell : target) {
    all += cell.weight;
  }
  const double f1 = scoreRange(range, target, rest).f1;
  Interval shortest{0, kHues, f1};
  forEachInterval(profile, true, all, [&](const Interval& interval) {
    if (std::abs(interval.f1 - f1) < kRounding && interval.length < shortest.length) {
      shortest = interval;
    }
  });
  ColorRange result = range;
  if (shortest.length < kHues) {
    setAxis(Axis::Hue, shortest, result);
  }
  return result;
}

} // namespace dewpoint::color
