// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_evidence.h"

#include "core/color/color_region.h"
#include "core/color/match_image.h"
#include "core/color/range_fit.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace dewpoint::color {
namespace {

/// Pixels around a region that are neither: blur and compression mix the colors there.
constexpr int kRim = 3;
/// An image still shows the sample when the region there has about its color, see colorDistance().
constexpr double kStillThere = 4.0;
/// How much larger or smaller than the sample the same thing may be in another view or moment.
constexpr double kOtherSize = 4.0;

struct Variant {
  double amount, weight;
};
constexpr std::array<Variant, 7> kBrightness{
    {{0.45, 0.05}, {0.6, 0.1}, {0.8, 0.2}, {1.0, 0.35}, {1.2, 0.15}, {1.45, 0.1}, {1.8, 0.05}}};
constexpr std::array<Variant, 5> kFullness{
    {{0.7, 0.1}, {0.85, 0.2}, {1.0, 0.4}, {1.15, 0.2}, {1.3, 0.1}}};
constexpr std::array<Variant, 5> kTint{
    {{-8.0, 0.1}, {-4.0, 0.2}, {0.0, 0.4}, {4.0, 0.2}, {8.0, 0.1}}};

bool stillShows(const cv::Mat& image, const cv::Mat& region, const ColorSample& sample) {
  std::vector<BgrColor> now;
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      if (region.at<std::uint8_t>(y, x) != 0) {
        const auto& pixel = image.at<cv::Vec3b>(y, x);
        now.push_back({pixel[0], pixel[1], pixel[2]});
      }
    }
  }
  const double growth = double(now.size()) / std::max(sample.area, 1);
  return !now.empty() && !sample.colors.empty() && growth < kOtherSize &&
         growth > 1.0 / kOtherSize &&
         colorDistance(medianColor(now), medianColor(sample.colors)) < kStillThere;
}

void widen(cv::Mat& mask) {
  const cv::Size size(2 * kRim + 1, 2 * kRim + 1);
  cv::dilate(mask, mask, cv::getStructuringElement(cv::MORPH_ELLIPSE, size));
}

/// Objects that match a range, as cv::connectedComponentsWithStats() tells them apart.
struct MatchingObjects {
  cv::Mat labels, statistics;
  int count = 0;

  MatchingObjects(const cv::Mat& image, const ColorRange& range) {
    cv::Mat centers;
    count = cv::connectedComponentsWithStats(matchImage(image, ColorClassifier(range)), labels,
                                             statistics, centers);
  }
  int area(int object) const { return statistics.at<int>(object, cv::CC_STAT_AREA); }
  /// Whether it can be a target of this area by its size.
  bool isAsLarge(int object, double target) const {
    return area(object) > target / (kOtherSize * kOtherSize) && area(object) < target * kOtherSize;
  }
};

/// The largest thing that matches, if it can be the target by its size; else nothing.
cv::Mat likelyTarget(const cv::Mat& image, const ColorRange& range, double area) {
  const MatchingObjects objects(image, range);
  int largest = 0;
  for (int i = 1; i < objects.count; ++i) {
    if (largest == 0 || objects.area(i) > objects.area(largest)) {
      largest = i;
    }
  }
  cv::Mat mask = cv::Mat::zeros(image.size(), CV_8UC1);
  if (largest > 0 && objects.isAsLarge(largest, area)) {
    mask.setTo(255, objects.labels == largest);
  }
  return mask;
}

/// Adds the rest of things that are in the mask already, by part: shading makes a target of one
/// color many.
void completeObjects(const cv::Mat& image, const ColorRange& range, double area, cv::Mat& mask) {
  const MatchingObjects objects(image, range);
  std::vector<bool> inMask(std::size_t(objects.count), false);
  for (int y = 0; y < mask.rows; ++y) {
    for (int x = 0; x < mask.cols; ++x) {
      if (mask.at<std::uint8_t>(y, x) != 0) {
        inMask[std::size_t(objects.labels.at<int>(y, x))] = true;
      }
    }
  }
  for (int i = 1; i < objects.count; ++i) {
    if (inMask[std::size_t(i)] && objects.isAsLarge(i, area)) {
      mask.setTo(255, objects.labels == i);
    }
  }
}

ColorSample clickInMiddle(ColorSample box) {
  box.x += box.width / 2.0;
  box.y += box.height / 2.0;
  box.width = box.height = 0.0;
  return box;
}

/// Where the clicks of one camera still show what was clicked; empty if nowhere.
cv::Mat clickedTargets(const std::vector<ColorSample>& samples, int camera, const cv::Mat& image) {
  cv::Mat mask;
  for (const ColorSample& sample : samples) {
    if (sample.camera != camera || sample.excluded) {
      continue;
    }
    const cv::Mat region = regionOfSample(image, sample);
    if (stillShows(image, region, sample)) {
      mask = mask.empty() ? region : cv::Mat(mask | region);
      if (sample.isBox()) { // what goes on around the box is not background
        mask |= regionOfSample(image, clickInMiddle(sample));
      }
    }
  }
  return mask;
}

/// Where no click shows it.
cv::Mat unclickedTarget(const cv::Mat& image, const ColorRange& typical,
                        const std::optional<ColorRange>& range, double area) {
  cv::Mat mask = likelyTarget(image, typical, area);
  if (range && cv::countNonZero(mask) == 0) {
    mask = likelyTarget(image, *range, area);
  } else if (range) {
    completeObjects(image, *range, area, mask);
  }
  return mask;
}

bool hasSamePixels(const cv::Mat& one, const cv::Mat& other) {
  return one.data == other.data && one.size() == other.size() && one.type() == other.type();
}

/// clickedTargets() of every image, as far as they are not known from `before`.
std::vector<cv::Mat> allClickedTargets(const std::vector<ColorSample>& samples,
                                       const std::vector<cv::Mat>& images,
                                       const ColorEvidence* before) {
  std::vector<cv::Mat> clicked(images.size());
  for (std::size_t i = 0; i < images.size(); ++i) {
    if (before != nullptr && i < before->images.size() &&
        hasSamePixels(images[i], before->images[i])) {
      clicked[i] = before->clicked[i];
    } else if (images[i].type() == CV_8UC3) {
      clicked[i] = clickedTargets(samples, int(i), images[i]);
    }
  }
  return clicked;
}

void addColors(const ColorSample& sample, double weight, HsiCounts& counts) {
  for (const BgrColor& color : sample.colors) {
    counts.add(color, weight / double(sample.colors.size()));
  }
}

} // namespace

std::vector<HsiColors> inOtherLight(const std::vector<HsiColors>& colors) {
  std::vector<HsiColors> result;
  result.reserve(colors.size() * kBrightness.size() * kFullness.size() * kTint.size());
  for (const HsiColors& cell : colors) {
    for (const Variant& light : kBrightness) {
      for (const Variant& full : kFullness) {
        for (const Variant& tint : kTint) {
          HsiColors& varied = result.emplace_back(cell);
          varied.color.intensity = std::min(1.0, cell.color.intensity * light.amount);
          varied.color.saturation = std::min(1.0, cell.color.saturation * full.amount);
          varied.color.hueDegrees = std::fmod(cell.color.hueDegrees + tint.amount + 360.0, 360.0);
          varied.weight = cell.weight * light.weight * full.weight * tint.weight;
        }
      }
    }
  }
  return result;
}

namespace {

ColorEvidence collect(const std::vector<ColorSample>& samples, const std::vector<cv::Mat>& images,
                      const std::optional<ColorRange>& range, const ColorEvidence* before) {
  ColorEvidence evidence;
  evidence.images = images;
  evidence.clicked = allClickedTargets(samples, images, before);
  const auto shown = std::ranges::count(samples, false, &ColorSample::excluded);
  for (const ColorSample& sample : samples) {
    evidence.targetArea += sample.excluded ? 0.0 : double(sample.area) / double(shown);
  }
  const auto views = std::ranges::count(images, CV_8UC3, [](const cv::Mat& m) { return m.type(); });
  // One target in every image, and each click counts the same: a far view is no less the target.
  const double weight = std::max(evidence.targetArea, 1.0) * double(std::max<long>(views, 1));
  HsiCounts target;
  HsiCounts rest;
  std::vector<BgrColor> sampled;
  for (const ColorSample& sample : samples) {
    if (sample.excluded) {
      addColors(sample, weight, rest);
    } else {
      addColors(sample, weight / double(shown), target);
      sampled.insert(sampled.end(), sample.colors.begin(), sample.colors.end());
    }
  }
  if (!sampled.empty()) {
    evidence.typicalColor = medianColor(std::move(sampled));
  }
  evidence.target = target.colors();
  const ColorRange typical = evidence.target.empty() ? ColorRange{} : fitRange(evidence.target, {});
  for (std::size_t i = 0; i < images.size(); ++i) {
    cv::Mat& mask = evidence.targetMasks.emplace_back();
    if (images[i].type() == CV_8UC3) {
      mask = evidence.clicked[i].empty()
                 ? unclickedTarget(images[i], typical, range, evidence.targetArea)
                 : evidence.clicked[i].clone();
      widen(mask);
      rest.add(images[i], mask);
      evidence.imageShare =
          std::max(evidence.imageShare, evidence.targetArea / double(images[i].total()));
    }
  }
  evidence.rest = rest.colors();
  evidence.targetWeight = target.total();
  evidence.restWeight = rest.total();
  return evidence;
}

} // namespace

ColorEvidence colorEvidence(const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images,
                            const std::optional<ColorRange>& range) {
  return collect(samples, images, range, nullptr);
}

ColorEvidence colorEvidence(const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images, const ColorRange& range,
                            const ColorEvidence& before) {
  bool settled = std::ranges::equal(images, before.images, hasSamePixels);
  // The range matters only where no click shows the target.
  for (std::size_t i = 0; settled && i < images.size(); ++i) {
    settled = images[i].type() != CV_8UC3 || !before.clicked[i].empty();
  }
  return settled ? before : collect(samples, images, range, &before);
}

} // namespace dewpoint::color
