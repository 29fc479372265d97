// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/sphere/color_reach.h"

#include "core/color/color_classifier.h"
#include "core/color/match_image.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace dewpoint::observation {
namespace {

// Judgments (docs/method-dewpoint.md, section 8).

constexpr int kMostRows = 360; ///< of an image that is looked at; a larger one is looked at smaller
/// Pixels of a thing that match before it counts as one.
constexpr int kFewestCore = 12;
/// Share of a thing that matches before: less is something else that touches it.
constexpr double kLeastCoreShare = 0.2;
/// Share of the image that may match anew elsewhere.
constexpr double kMostElsewhere = 0.0015;
/// Of what matched before, by how much the things must grow: less is their blurred rim.
constexpr double kWorthwhileGrowth = 0.12;
/// Saturation below which a hue is noise: no bound is moved there.
constexpr double kLeastSaturation = 0.02;

/// Which bound is moved, both of the saturation at once, and how far at most.
enum class Bound { Darker, Saturation, LowerHue, HigherHue, Brighter };
struct Step {
  Bound bound;
  double amount; ///< factor of the intensity, else saturation (0 to 1) or degrees
};
/// The farthest first; of each bound the first that is allowed is taken.
constexpr std::array<Step, 14> kSteps{{{Bound::Darker, 0.3},
                                       {Bound::Darker, 0.45},
                                       {Bound::Darker, 0.65},
                                       {Bound::Darker, 0.8},
                                       {Bound::Saturation, 0.2},
                                       {Bound::Saturation, 0.12},
                                       {Bound::Saturation, 0.06},
                                       {Bound::LowerHue, 16.0},
                                       {Bound::LowerHue, 10.0},
                                       {Bound::LowerHue, 5.0},
                                       {Bound::HigherHue, 16.0},
                                       {Bound::HigherHue, 10.0},
                                       {Bound::HigherHue, 5.0},
                                       {Bound::Brighter, 1.4}}};

ColorRange moved(ColorRange range, const Step& step) {
  switch (step.bound) {
  case Bound::Darker:
    range.intensityMin *= step.amount;
    break;
  case Bound::Brighter:
    range.intensityMax = std::min(1.0, range.intensityMax * step.amount);
    break;
  case Bound::Saturation:
    range.saturationMin = std::min(range.saturationMin,
                                   std::max(kLeastSaturation, range.saturationMin - step.amount));
    range.saturationMax = std::min(1.0, range.saturationMax + step.amount);
    break;
  case Bound::LowerHue:
    range.hueMin = normalizedHue(range.hueMin - step.amount);
    break;
  case Bound::HigherHue:
    range.hueMax = normalizedHue(range.hueMax + step.amount);
    break;
  }
  return range;
}

/// What matches more than before, by where it lies.
struct Growth {
  int joined = 0;    ///< pixels of things that matched before
  int elsewhere = 0; ///< other pixels
};

Growth growthOf(const cv::Mat& before, const cv::Mat& now) {
  cv::Mat labels;
  cv::Mat closed;
  cv::medianBlur(now, closed, 3);
  const int count = cv::connectedComponents(closed, labels, 8, CV_32S);
  std::vector<int> all(static_cast<std::size_t>(count));
  std::vector<int> core(static_cast<std::size_t>(count));
  for (int row = 0; row < labels.rows; ++row) {
    const auto* label = labels.ptr<int>(row);
    const auto* matched = before.ptr<std::uint8_t>(row);
    for (int column = 0; column < labels.cols; ++column) {
      const auto thing = static_cast<std::size_t>(label[column]);
      ++all[thing];
      core[thing] += matched[column] != 0 ? 1 : 0;
    }
  }
  Growth growth;
  for (std::size_t thing = 1; thing < all.size(); ++thing) { // 0 is what does not match
    const bool same = core[thing] >= kFewestCore && core[thing] >= kLeastCoreShare * all[thing];
    (same ? growth.joined : growth.elsewhere) += all[thing] - core[thing];
  }
  return growth;
}

cv::Mat matched(const cv::Mat& image, const ColorRange& range) {
  return matchImage(image, ColorClassifier(range));
}

} // namespace

ColorRange extendRangeToLight(const ColorRange& learned, const cv::Mat& image) {
  if (image.type() != CV_8UC3 || image.empty() || spansEveryHue(learned)) {
    return learned;
  }
  cv::Mat small = image;
  if (image.rows > kMostRows) {
    const double factor = static_cast<double>(kMostRows) / image.rows;
    cv::resize(image, small, {}, factor, factor, cv::INTER_AREA);
  }
  const cv::Mat first = matched(small, learned);
  const int core = cv::countNonZero(first);
  if (core < kFewestCore) {
    return learned;
  }
  const int elsewhere = static_cast<int>(kMostElsewhere * static_cast<double>(small.total()));
  ColorRange range = learned;
  std::optional<Bound> done;
  Growth best;
  for (const Step& step : kSteps) {
    if (done == step.bound) {
      continue;
    }
    const ColorRange wider = moved(range, step);
    if (!checkColorRange(wider).has_value() || spansEveryHue(wider)) {
      continue;
    }
    const Growth growth = growthOf(first, matched(small, wider));
    if (growth.elsewhere <= elsewhere) {
      range = wider;
      best = growth;
      done = step.bound;
    }
  }
  return best.joined >= kWorthwhileGrowth * core ? range : learned;
}

} // namespace dewpoint::observation
