// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/sample_colors.h"

#include "core/color/color_evidence.h"
#include "core/color/color_region.h"
#include "core/color/range_fit.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace dewpoint::color {
namespace {

// Judgments; docs/method-color.md, "Several colors".

/// Samples that differ by no more show one color, colorDistance(). White balances of cameras make
/// up to 6 of one color, orange and yellow differ by 10, red and white by 26.
constexpr double kOneColor = 8.0;
/// F1 score that several ranges must gain over one: each is one more thing to look after.
constexpr double kWorthSeveral = 0.05;

using Group = std::vector<std::size_t>;

/// Of the two samples that differ most.
double distanceBetween(const Group& one, const Group& other, const std::vector<BgrColor>& colors) {
  double greatest = 0.0;
  for (const std::size_t a : one) {
    for (const std::size_t b : other) {
      greatest = std::max(greatest, colorDistance(colors[a], colors[b]));
    }
  }
  return greatest;
}

struct Pair {
  std::size_t first = 0, second = 0;
  double distance = std::numeric_limits<double>::infinity();
};
Pair nearestGroups(const std::vector<Group>& groups, const std::vector<BgrColor>& colors) {
  Pair nearest;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (std::size_t j = i + 1; j < groups.size(); ++j) {
      const double distance = distanceBetween(groups[i], groups[j], colors);
      if (distance < nearest.distance) {
        nearest = {i, j, distance};
      }
    }
  }
  return nearest;
}

bool isBlack(const std::vector<WeightedHsiColor>& colors) {
  return std::ranges::none_of(
      colors, [](const WeightedHsiColor& cell) { return cell.color.intensity > 0.0; });
}

/// The best range for each color of the target, but for black.
std::vector<ColorRange> rangeOfEach(const ColorEvidence& evidence) {
  std::vector<ColorRange> ranges;
  for (const std::vector<WeightedHsiColor>& seen : evidence.targetColorsBySampleColor) {
    if (!isBlack(seen)) {
      const auto color = withLightVariations(seen);
      ranges.push_back(
          withNarrowestHue(fitRange(color, evidence.restColors), color, evidence.restColors));
    }
  }
  return ranges;
}

} // namespace

std::vector<std::vector<std::size_t>> groupSamplesByColor(const std::vector<ColorSample>& samples) {
  std::vector<Group> groups;
  std::vector<BgrColor> colors(samples.size());
  for (std::size_t k = 0; k < samples.size(); ++k) {
    if (!samples[k].isExcluded && !samples[k].colors.empty()) {
      colors[k] = medianColor(samples[k].colors);
      groups.push_back({k});
    }
  }
  for (Pair nearest = nearestGroups(groups, colors);
       groups.size() > 1 && (nearest.distance <= kOneColor || groups.size() > kMaxTargetColors);
       nearest = nearestGroups(groups, colors)) {
    Group& kept = groups[nearest.first];
    std::ranges::copy(groups[nearest.second], std::back_inserter(kept));
    std::ranges::sort(kept);
    groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(nearest.second));
  }
  std::ranges::sort(groups);
  return groups;
}

std::optional<ColorRanges> multicolorRanges(const ColorEvidence& evidence, const ColorRange& one) {
  if (evidence.targetColorsBySampleColor.size() < 2) {
    return std::nullopt;
  }
  const auto target = withLightVariations(evidence.targetColors);
  const std::vector<ColorRange> each = rangeOfEach(evidence);
  double bestF1 = scoreRange(one, target, evidence.restColors).f1 + kWorthSeveral;
  std::optional<ColorRanges> best;
  // All choices of two and more: few, as kMaxTargetColors is.
  for (std::size_t chosen = 1; chosen < std::size_t{1} << each.size(); ++chosen) {
    std::vector<ColorRange> ranges;
    for (std::size_t k = 0; k < each.size(); ++k) {
      if ((chosen >> k & 1U) != 0) {
        ranges.push_back(each[k]);
      }
    }
    if (ranges.size() < 2) {
      continue;
    }
    ColorRanges tried(std::move(ranges));
    const double f1 = scoreRange(tried, target, evidence.restColors).f1;
    if (f1 > bestF1) {
      bestF1 = f1;
      best = std::move(tried);
    }
  }
  return best;
}

} // namespace dewpoint::color
