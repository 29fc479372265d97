// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_region.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

namespace dewpoint::color {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Of an image of distances.
constexpr int kLevels = 256;
constexpr double kLevelsPerUnit = 12.0; ///< so that distances up to 21 are told apart
constexpr double kShareNoise = 0.02;    ///< of r/(r+g+b): material, compression
constexpr double kGrayLevelNoise = 5.0; ///< of a channel
constexpr double kShadingScale = 0.5;   ///< natural logarithm of the brightness
constexpr double kDarkest = 20.0;       ///< sum of channels where brightness stops to say much
constexpr int kSmallest = 12;           ///< pixels of a region
constexpr double kLargestShare = 0.5;   ///< of the image: more is no object in it
constexpr double kNoOutline = 1.0;      ///< units of colorDistance(): a box lies within the object
constexpr int kSeedReach = 2;           ///< pixels around the click whose median begins
/// Pixels across an outline over which its edge is seen: moving objects are blurred, and the larger
/// they appear the farther. Each counts from this radius of a region on, pixels.
constexpr std::array<int, 3> kEdgeReach{2, 3, 4};
constexpr std::array<double, 3> kReachFromRadius{0.0, 8.0, 16.0};
/// Mean distance of a region from the clicked color, in levels: what counts little, and what is too
/// much for one object.
constexpr double kLittleSpread = kLevelsPerUnit;
constexpr double kMostSpread = 3.0 * kLevelsPerUnit;
constexpr double kOutlineSlack = 1.3; ///< of the area, within which an outline is moved
/// Times that a click is corrected to the region it hit.
constexpr int kCorrections = 2;
constexpr double kSameObject = 4.0; ///< colorDistance() up to which a click is corrected

BgrColor pixelAt(const cv::Mat& bgr, int x, int y) {
  const std::uint8_t* pixel = bgr.ptr<std::uint8_t>(y) + 3 * std::ptrdiff_t{x};
  return {pixel[0], pixel[1], pixel[2]};
}

/// Distances of all pixels to one color, in levels.
cv::Mat levelsFrom(const cv::Mat& bgr, const BgrColor& color) {
  cv::Mat levels(bgr.size(), CV_8UC1);
  for (int y = 0; y < bgr.rows; ++y) {
    std::uint8_t* row = levels.ptr<std::uint8_t>(y);
    for (int x = 0; x < bgr.cols; ++x) {
      const double level = colorDistance(pixelAt(bgr, x, y), color) * kLevelsPerUnit;
      row[x] = static_cast<std::uint8_t>(std::min(level, kLevels - 1.0));
    }
  }
  return levels;
}

const std::array<cv::Point, 4> kNeighbors{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

/// The least level that must be allowed to come from the click to each pixel; kLevels where the
/// flood did not come, because it had become too large.
cv::Mat floodLevels(const cv::Mat& levels, cv::Point click, double largest) {
  cv::Mat flood(levels.size(), CV_16UC1, cv::Scalar(kLevels));
  std::vector<std::vector<cv::Point>> waiting(kLevels);
  const cv::Rect frame({0, 0}, levels.size());
  const auto limit = static_cast<std::size_t>(largest);
  flood.at<std::uint16_t>(click) = 0;
  waiting[0].push_back(click);
  std::size_t area = 0;
  for (int level = 0; level < kLevels && area < limit; ++level) {
    auto& queue = waiting[static_cast<std::size_t>(level)];
    while (!queue.empty()) {
      const cv::Point at = queue.back();
      queue.pop_back();
      ++area;
      for (const cv::Point step : kNeighbors) {
        const cv::Point next = at + step;
        if (!frame.contains(next) || flood.at<std::uint16_t>(next) != kLevels) {
          continue;
        }
        const int there = std::max<int>(level, levels.at<std::uint8_t>(next));
        flood.at<std::uint16_t>(next) = static_cast<std::uint16_t>(there);
        waiting[static_cast<std::size_t>(there)].push_back(next);
      }
    }
  }
  return flood;
}

using Steps = std::array<double, kEdgeReach.size()>;

/// Per level: area of the region, the sum of its pixels' levels, length of its outline in pixel
/// edges, and the steps across it for each reach.
struct NestedRegions {
  using PerLevel = std::array<double, kLevels + 1>;
  PerLevel area{}, levelSum{}, outline{};
  std::array<PerLevel, kEdgeReach.size()> contrast{};

  void addEdge(int from, int to, const Steps& steps) { // an outline from level `from` until `to`
    outline[std::size_t(from)] += 1.0;
    outline[std::size_t(to)] -= 1.0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      contrast[i][std::size_t(from)] += steps[i];
      contrast[i][std::size_t(to)] -= steps[i];
    }
  }
  void accumulate() {
    for (PerLevel* values :
         {&area, &levelSum, &outline, &contrast[0], &contrast[1], &contrast[2]}) {
      std::partial_sum(values->begin(), values->end(), values->begin());
    }
  }
  /// Mean level in the region.
  double spread(std::size_t level) const { return levelSum[level] / area[level]; }

  /// The strength of the edge along the outline against the differences within it (Fisher's
  /// criterion), a little less where it is ragged.
  double score(std::size_t level) const {
    const double radius = std::sqrt(area[level] / std::numbers::pi);
    const auto larger = std::ranges::upper_bound(kReachFromRadius, radius);
    const auto reach = std::size_t(larger - kReachFromRadius.begin()) - 1;
    const double compact = 4.0 * std::numbers::pi * area[level] / (outline[level] * outline[level]);
    return contrast[reach][level] / outline[level] / (kLittleSpread + spread(level)) *
           std::pow(std::min(1.0, compact), 0.25);
  }
};

std::uint8_t clampedLevel(const cv::Mat& levels, cv::Point at) {
  return levels.at<std::uint8_t>(std::clamp(at.y, 0, levels.rows - 1),
                                 std::clamp(at.x, 0, levels.cols - 1));
}

/// How much farther from the clicked color it is outside than inside, across the outline between a
/// pixel and the next one.
Steps stepsAcross(const cv::Mat& levels, cv::Point at, cv::Point step) {
  Steps steps{};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const int inside = clampedLevel(levels, at - (kEdgeReach[i] - 1) * step);
    const int outside = clampedLevel(levels, at + kEdgeReach[i] * step);
    steps[i] = std::max(0, outside - inside);
  }
  return steps;
}

NestedRegions nestedRegions(const cv::Mat& levels, const cv::Mat& flood) {
  NestedRegions regions;
  const cv::Rect frame({0, 0}, levels.size());
  for (int y = 0; y < flood.rows; ++y) {
    for (int x = 0; x < flood.cols; ++x) {
      const cv::Point at{x, y};
      const int here = flood.at<std::uint16_t>(at);
      if (here == kLevels) {
        continue;
      }
      regions.area[std::size_t(here)] += 1.0;
      regions.levelSum[std::size_t(here)] += levels.at<std::uint8_t>(at);
      for (const cv::Point step : kNeighbors) {
        const cv::Point next = at + step;
        if (!frame.contains(next)) {
          regions.addEdge(here, kLevels, {}); // the image's end is no edge
        } else if (const int there = flood.at<std::uint16_t>(next); there > here) {
          regions.addEdge(here, there, stepsAcross(levels, at, step));
        }
      }
    }
  }
  regions.accumulate();
  return regions;
}

/// What is inside an outline is part of it: highlights, writing.
void fillHoles(cv::Mat& mask) {
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(mask.clone(), outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  cv::drawContours(mask, outlines, -1, cv::Scalar(255), cv::FILLED);
}

/// The level of the best region with at most so much spread and so large; nothing if there is none.
std::optional<std::size_t> bestLevel(const NestedRegions& regions, double spread, double area) {
  std::optional<std::size_t> best;
  for (std::size_t level = 0; level + 1 < kLevels; ++level) {
    if (regions.area[level] >= kSmallest && regions.area[level] < area &&
        regions.outline[level] > 0.0 && regions.spread(level) <= spread &&
        (!best || regions.score(level) > regions.score(*best))) {
      best = level;
    }
  }
  return best;
}

/// Seen over many pixels an outline lies too far inside; where it is steepest is where it is.
std::size_t steepestFrom(const NestedRegions& regions, std::size_t level) {
  const auto steepness = [&](std::size_t at) {
    return regions.contrast[0][at] / regions.outline[at];
  };
  std::size_t best = level;
  for (std::size_t next = level; next + 1 < kLevels; ++next) {
    if (regions.area[next] > kOutlineSlack * regions.area[level]) {
      break;
    }
    best = steepness(next) > steepness(best) ? next : best;
  }
  return best;
}

/// `bounded`: the image is a box that a person has dragged; it may lie within the object.
cv::Mat regionFrom(const cv::Mat& bgr, cv::Point click, const BgrColor& color, bool bounded) {
  const cv::Mat levels = levelsFrom(bgr, color);
  const double limit = (bounded ? 1.0 : kLargestShare) * static_cast<double>(bgr.total());
  const cv::Mat flood = floodLevels(levels, click, limit);
  const NestedRegions regions = nestedRegions(levels, flood);
  auto best = bestLevel(regions, kMostSpread, limit);
  best = best ? best : bestLevel(regions, kLevels, limit); // a colorful thing, or a tiny one
  if (bounded && (!best || regions.contrast[0][*best] <
                               kNoOutline * kLevelsPerUnit * regions.outline[*best])) {
    return {bgr.size(), CV_8UC1, cv::Scalar(255)};
  }
  cv::Mat mask =
      best ? cv::Mat(flood <= double(steepestFrom(regions, *best))) : cv::Mat(flood < kLevels);
  fillHoles(mask);
  return mask;
}

} // namespace

double colorDistance(const BgrColor& one, const BgrColor& other) {
  const double sum = double(one[0]) + one[1] + one[2];
  const double otherSum = double(other[0]) + other[1] + other[2];
  const double noise = kGrayLevelNoise / std::max(sum, 1.0);
  const double otherNoise = kGrayLevelNoise / std::max(otherSum, 1.0);
  double square = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = one[i] / std::max(sum, 1.0) - other[i] / std::max(otherSum, 1.0);
    square += share * share;
  }
  square /= kShareNoise * kShareNoise + noise * noise + otherNoise * otherNoise;
  const double shading = std::log((sum + kDarkest) / (otherSum + kDarkest)) / kShadingScale;
  return std::sqrt(square + shading * shading);
}

std::vector<BgrColor> colorsIn(const cv::Mat& bgr, const cv::Mat& mask) {
  std::vector<BgrColor> colors;
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      if (mask.at<std::uint8_t>(y, x) != 0) {
        colors.push_back(pixelAt(bgr, x, y));
      }
    }
  }
  return colors;
}

BgrColor medianColor(std::vector<BgrColor> colors) {
  BgrColor median{}; // bytes in place: upperMedian() would copy each channel to floating point
  const auto middle = colors.begin() + std::ptrdiff_t(colors.size() / 2);
  for (std::size_t i = 0; i < 3; ++i) {
    std::ranges::nth_element(colors, middle, {}, [i](const BgrColor& color) { return color[i]; });
    median[i] = (*middle)[i];
  }
  return median;
}

cv::Mat growRegion(const cv::Mat& bgr, cv::Point click, cv::Rect within) {
  const cv::Rect frame({0, 0}, bgr.size());
  const cv::Rect part = within.empty() ? frame : within & frame;
  cv::Mat smooth;
  cv::medianBlur(bgr(part), smooth, 3);
  const cv::Point at = click - part.tl();
  const cv::Rect seed =
      cv::Rect(at.x - kSeedReach, at.y - kSeedReach, 2 * kSeedReach + 1, 2 * kSeedReach + 1) &
      cv::Rect({0, 0}, part.size());
  BgrColor color =
      medianColor(colorsIn(smooth(seed), cv::Mat(seed.size(), CV_8UC1, cv::Scalar(255))));
  cv::Mat region;
  for (int i = 0; i <= kCorrections; ++i) {
    region = regionFrom(smooth, at, color, !within.empty());
    const BgrColor middle = medianColor(colorsIn(smooth, region));
    if (colorDistance(middle, color) > kSameObject) {
      break; // it would become something else
    }
    color = middle;
  }
  cv::Mat mask = cv::Mat::zeros(bgr.size(), CV_8UC1);
  region.copyTo(mask(part));
  return mask;
}

cv::Mat regionOfSample(const cv::Mat& bgr, const ColorSample& sample) {
  const cv::Point at(static_cast<int>(std::lround(sample.x + sample.width / 2.0)),
                     static_cast<int>(std::lround(sample.y + sample.height / 2.0)));
  if (!cv::Rect({0, 0}, bgr.size()).contains(at)) {
    return cv::Mat::zeros(bgr.size(), CV_8UC1);
  }
  const cv::Rect box = sample.isBox()
                           ? cv::Rect(static_cast<int>(sample.x), static_cast<int>(sample.y),
                                      static_cast<int>(std::ceil(sample.width)),
                                      static_cast<int>(std::ceil(sample.height)))
                           : cv::Rect{};
  cv::Mat region = growRegion(bgr, at, box);
  const cv::Rect within = box & cv::Rect({0, 0}, bgr.size());
  if (!within.empty() && cv::countNonZero(region) == within.area()) { // no outline in it
    cv::Mat thing = growRegion(bgr, at);
    thing &= region;
    region = cv::countNonZero(thing) < kMinBoxFill * within.area() ? region : thing;
  }
  return region;
}

} // namespace dewpoint::color
