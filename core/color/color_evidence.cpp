// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/color/color_evidence.h"

#include "core/color/color_region.h"
#include "core/color/match_image.h"
#include "core/color/range_fit.h"
#include "core/color/sample_colors.h"

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
  const double growth = double(now.size()) / std::max(sample.areaPx, 1);
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

  MatchingObjects(const cv::Mat& image, const ColorRanges& ranges, EvidenceWorkCounts& work) {
    ++work.floodFillCount;
    cv::Mat centers;
    count = cv::connectedComponentsWithStats(matchImage(image, ColorClassifier(ranges)), labels,
                                             statistics, centers);
  }
  int area(int object) const { return statistics.at<int>(object, cv::CC_STAT_AREA); }
  /// Whether it can be a target of this area by its size.
  bool isAsLarge(int object, double target) const {
    return area(object) > target / (kOtherSize * kOtherSize) && area(object) < target * kOtherSize;
  }
};

/// The largest thing that matches, if it can be the target by its size; else nothing.
cv::Mat likelyTarget(const cv::Mat& image, const ColorRanges& ranges, double area,
                     EvidenceWorkCounts& work) {
  const MatchingObjects objects(image, ranges, work);
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
void completeObjects(const cv::Mat& image, const ColorRanges& ranges, double area, cv::Mat& mask,
                     EvidenceWorkCounts& work) {
  const MatchingObjects objects(image, ranges, work);
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
cv::Mat clickedTargets(const std::vector<ColorSample>& samples, int camera, const cv::Mat& image,
                       EvidenceWorkCounts& work) {
  cv::Mat mask;
  for (const ColorSample& sample : samples) {
    if (sample.camera != camera || sample.isExcluded) {
      continue;
    }
    ++work.grownRegionCount;
    const cv::Mat region = regionOfSample(image, sample);
    if (stillShows(image, region, sample)) {
      mask = mask.empty() ? region : cv::Mat(mask | region);
      if (sample.isBox()) { // what goes on around the box is not background
        ++work.grownRegionCount;
        mask |= regionOfSample(image, clickInMiddle(sample));
      }
    }
  }
  return mask;
}

/// Where no click shows it: `similar`, an object of the typical colors, as far as it matches.
cv::Mat unclickedTarget(const cv::Mat& image, const cv::Mat& similar,
                        const std::optional<ColorRanges>& ranges, double area,
                        EvidenceWorkCounts& work) {
  if (!ranges) {
    return similar.clone();
  }
  if (cv::countNonZero(similar) == 0) {
    return likelyTarget(image, *ranges, area, work);
  }
  cv::Mat mask = similar.clone();
  completeObjects(image, *ranges, area, mask, work);
  return mask;
}

bool hasSamePixels(const cv::Mat& one, const cv::Mat& other) {
  return one.data == other.data && one.size() == other.size() && one.type() == other.type();
}

void addColors(const ColorSample& sample, double weight, HsiCounts& counts) {
  for (const BgrColor& color : sample.colors) {
    counts.add(color, weight / double(sample.colors.size()));
  }
}

} // namespace

std::vector<WeightedHsiColor> withLightVariations(const std::vector<WeightedHsiColor>& colors) {
  std::vector<WeightedHsiColor> result;
  result.reserve(colors.size() * kBrightness.size() * kFullness.size() * kTint.size());
  for (const WeightedHsiColor& cell : colors) {
    for (const Variant& light : kBrightness) {
      for (const Variant& full : kFullness) {
        for (const Variant& tint : kTint) {
          WeightedHsiColor& varied = result.emplace_back(cell);
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

/// Pixels are whole numbers, whose sums are exact in any order. The shares of an excluded sample
/// are not: for the same bits, what is counted after them is counted again.
bool areSumsExact(const std::vector<ColorSample>& samples) {
  return std::ranges::none_of(samples, &ColorSample::isExcluded);
}

/// An image and its target mask; both empty where there is none.
struct MaskedImage {
  cv::Mat image, mask;

  static MaskedImage of(const ColorEvidence& evidence, std::size_t camera) {
    return camera < evidence.images.size()
               ? MaskedImage{evidence.images[camera].image, evidence.targetMasks[camera]}
               : MaskedImage{};
  }
  bool operator==(const MaskedImage& other) const {
    return hasSamePixels(image, other.image) && mask.size() == other.mask.size() &&
           (mask.empty() || cv::norm(mask, other.mask, cv::NORM_INF) == 0.0);
  }
};

/// Counts the pixels beside the mask in `now` in place of those in `before`.
void recount(const MaskedImage& before, const MaskedImage& now, HsiCounts& counts) {
  if (hasSamePixels(before.image, now.image)) {
    counts.add(now.image, before.mask | ~now.mask, -1.0);
    counts.add(now.image, now.mask | ~before.mask);
  } else {
    counts.add(before.image, before.mask, -1.0);
    counts.add(now.image, now.mask);
  }
}

/// Collects the evidence of samples and images, as far as it is not known from before.
class EvidenceCollector {
public:
  /// `before` of the same samples; null when nothing is known.
  EvidenceCollector(const std::vector<ColorSample>& samples, const ColorEvidence* before)
      : samples_(samples), before_(before) {}

  /// What the samples alone show, for so many images.
  void takeSamples(std::int64_t views);
  /// The image of the next camera, and where it may show the target.
  void takeImage(const cv::Mat& image, const std::optional<ColorRanges>& ranges,
                 const cv::Mat& undecided);
  /// After all images.
  ColorEvidence finish() &&;

private:
  /// One target in every image, and each click counts the same: a far view is no less the target.
  double targetWeight() const {
    return std::max(evidence_.targetAreaPx, 1.0) *
           double(std::max<std::int64_t>(evidence_.viewCount, 1));
  }
  /// The target's colors, each sample of this weight, and what is typical of each.
  void divideColors(double weight);
  void countRest();

  const std::vector<ColorSample>& samples_;
  const ColorEvidence* before_;
  ColorEvidence evidence_;
};

void EvidenceCollector::takeSamples(std::int64_t views) {
  evidence_.viewCount = views;
  const auto shown = std::ranges::count(samples_, false, &ColorSample::isExcluded);
  for (const ColorSample& sample : samples_) {
    evidence_.targetAreaPx += sample.isExcluded ? 0.0 : double(sample.areaPx) / double(shown);
  }
  if (before_ != nullptr && before_->viewCount == views) {
    evidence_.targetColors = before_->targetColors;
    evidence_.targetColorsBySampleColor = before_->targetColorsBySampleColor;
    evidence_.targetWeight = before_->targetWeight;
    evidence_.typicalColor = before_->typicalColor;
    evidence_.typicalRanges = before_->typicalRanges;
    return;
  }
  HsiCounts target;
  std::vector<BgrColor> sampled;
  for (const ColorSample& sample : samples_) {
    if (!sample.isExcluded) {
      addColors(sample, targetWeight() / double(shown), target);
      sampled.insert(sampled.end(), sample.colors.begin(), sample.colors.end());
    }
  }
  if (!sampled.empty()) {
    evidence_.typicalColor = medianColor(std::move(sampled));
  }
  evidence_.targetColors = target.colors();
  evidence_.targetWeight = target.totalWeight();
  if (!evidence_.targetColors.empty()) {
    divideColors(targetWeight() / double(shown));
  }
}

void EvidenceCollector::divideColors(double weight) {
  const auto groups = groupSamplesByColor(samples_);
  if (groups.size() < 2) {
    evidence_.typicalRanges = fitRange(evidence_.targetColors, {});
    return;
  }
  std::vector<ColorRange> typical;
  typical.reserve(groups.size());
  for (const std::vector<std::size_t>& group : groups) {
    HsiCounts counts;
    for (const std::size_t sample : group) {
      addColors(samples_[sample], weight, counts);
    }
    evidence_.targetColorsBySampleColor.push_back(counts.colors());
    typical.push_back(fitRange(evidence_.targetColorsBySampleColor.back(), {}));
  }
  evidence_.typicalRanges = ColorRanges(std::move(typical));
}

void EvidenceCollector::takeImage(const cv::Mat& image, const std::optional<ColorRanges>& ranges,
                                  const cv::Mat& undecided) {
  const std::size_t camera = evidence_.images.size();
  ImageEvidence& shown = evidence_.images.emplace_back(ImageEvidence{image, {}, {}, undecided});
  cv::Mat& mask = evidence_.targetMasks.emplace_back();
  if (image.type() != CV_8UC3) {
    return;
  }
  const double area = evidence_.targetAreaPx;
  evidence_.targetShareOfImage =
      std::max(evidence_.targetShareOfImage, area / double(image.total()));
  const bool isKnown = before_ != nullptr && camera < before_->images.size() &&
                       hasSamePixels(image, before_->images[camera].image);
  shown.clickedMask = isKnown ? before_->images[camera].clickedMask
                              : clickedTargets(samples_, int(camera), image, evidence_.workCounts);
  if (!shown.clickedMask.empty()) {
    mask = shown.clickedMask.clone();
  } else {
    shown.similarColorMask =
        isKnown && evidence_.typicalRanges == before_->typicalRanges
            ? before_->images[camera].similarColorMask
            : likelyTarget(image, evidence_.typicalRanges, area, evidence_.workCounts);
    mask = unclickedTarget(image, shown.similarColorMask, ranges, area, evidence_.workCounts);
  }
  if (undecided.size() == mask.size()) {
    mask |= undecided;
  }
  widen(mask);
}

void EvidenceCollector::countRest() {
  const bool goesOn = before_ != nullptr && areSumsExact(samples_);
  HsiCounts rest = goesOn ? *before_->restCounts : HsiCounts{};
  for (const ColorSample& sample : samples_) {
    if (sample.isExcluded) {
      addColors(sample, targetWeight(), rest);
    }
  }
  const std::size_t count = evidence_.images.size();
  for (std::size_t i = 0; i < std::max(count, goesOn ? before_->images.size() : 0); ++i) {
    const auto before = goesOn ? MaskedImage::of(*before_, i) : MaskedImage{};
    const auto now = MaskedImage::of(evidence_, i);
    if (!(now == before)) {
      recount(before, now, rest);
      ++evidence_.workCounts.countedImageCount;
    }
  }
  evidence_.restColors = rest.colors();
  evidence_.restWeight = rest.totalWeight();
  evidence_.restCounts = std::make_shared<const HsiCounts>(std::move(rest));
}

ColorEvidence EvidenceCollector::finish() && {
  bool same = before_ != nullptr && before_->viewCount == evidence_.viewCount;
  for (std::size_t i = 0; same && i < std::max(evidence_.images.size(), before_->images.size());
       ++i) {
    same = MaskedImage::of(evidence_, i) == MaskedImage::of(*before_, i);
  }
  if (same) {
    evidence_.restColors = before_->restColors;
    evidence_.restWeight = before_->restWeight;
    evidence_.restCounts = before_->restCounts;
  } else {
    countRest();
  }
  return std::move(evidence_);
}

ColorEvidence collect(const std::vector<ColorSample>& samples, const std::vector<cv::Mat>& images,
                      const std::optional<ColorRanges>& ranges,
                      const std::vector<cv::Mat>& undecided, const ColorEvidence* before) {
  EvidenceCollector collector(samples, before);
  collector.takeSamples(
      std::ranges::count(images, CV_8UC3, [](const cv::Mat& image) { return image.type(); }));
  for (std::size_t camera = 0; camera < images.size(); ++camera) {
    collector.takeImage(images[camera], ranges,
                        camera < undecided.size() ? undecided[camera] : cv::Mat());
  }
  return std::move(collector).finish();
}

} // namespace

ColorEvidence collectColorEvidence(const std::vector<ColorSample>& samples,
                                   const std::vector<cv::Mat>& images,
                                   const std::optional<ColorRanges>& ranges,
                                   const std::vector<cv::Mat>& undecided) {
  return collect(samples, images, ranges, undecided, nullptr);
}

ColorEvidence collectColorEvidence(const std::vector<ColorSample>& samples,
                                   const std::vector<cv::Mat>& images, const ColorRanges& ranges,
                                   const ColorEvidence& before) {
  std::vector<cv::Mat> undecided;
  for (const ImageEvidence& image : before.images) {
    undecided.push_back(image.undecidedMask);
  }
  return collect(samples, images, ranges, undecided, &before);
}

} // namespace dewpoint::color
