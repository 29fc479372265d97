// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/clicks/click_learning.h"

#include "core/color/color_region.h"
#include "core/color/sample_colors.h"
#include "core/project/project_rig.h"
#include "core/setup/clicks/clicked_correction.h"
#include "core/setup/clicks/clicked_position.h"
#include "core/setup/clicks/ray_regions.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace dewpoint::setup {
namespace {

bool isClick(const ColorSample& sample) {
  return !sample.isExcluded && !sample.isFoundByGeometry;
}

bool hasClickAt(const std::vector<ColorSample>& samples, std::int64_t frame) {
  return std::ranges::any_of(
      samples, [&](const ColorSample& sample) { return isClick(sample) && sample.frame == frame; });
}

/// Whether there is one of this camera in the images of a frame.
bool showsTarget(const std::vector<ColorSample>& samples, int camera, std::int64_t frame) {
  return std::ranges::any_of(samples, [&](const ColorSample& sample) {
    return !sample.isExcluded && sample.camera == camera && sample.frame == frame;
  });
}

/// Puts clicks and exclusions first, and behind them what was found in other frames than `frame`.
std::vector<ColorSample> reorderedSamples(const std::vector<ColorSample>& samples,
                                          std::int64_t frame) {
  std::vector<ColorSample> kept;
  std::ranges::copy_if(samples, std::back_inserter(kept),
                       [](const ColorSample& sample) { return !sample.isFoundByGeometry; });
  std::ranges::copy_if(samples, std::back_inserter(kept), [&](const ColorSample& sample) {
    return sample.isFoundByGeometry && sample.frame != frame && hasClickAt(samples, sample.frame);
  });
  return kept;
}

/// Adds a mask to another one, which may be empty; both of one size.
void unite(const cv::Mat& added, cv::Mat& mask) {
  if (!added.empty()) {
    mask = mask.empty() ? added : cv::Mat(mask | added);
  }
}

BgrColor typicalColor(const std::vector<ColorSample>& samples) {
  std::vector<BgrColor> colors;
  for (const ColorSample& sample : samples) {
    if (isClick(sample)) {
      colors.insert(colors.end(), sample.colors.begin(), sample.colors.end());
    }
  }
  return colors.empty() ? BgrColor{} : color::medianColor(std::move(colors));
}

/// colorDistance() of regions that may be of the same object.
constexpr double kSameColorDistance = 4.0;

/// The samples of other targets in the images of a frame whose color is about that of `samples`.
std::vector<ColorSample> samplesOfSameColor(const std::vector<ColorSample>& others,
                                            const std::vector<ColorSample>& samples,
                                            std::int64_t frame) {
  const BgrColor own = typicalColor(samples);
  std::vector<ColorSample> alike;
  std::ranges::copy_if(others, std::back_inserter(alike), [&](const ColorSample& sample) {
    return !sample.isExcluded && sample.frame == frame && !sample.colors.empty() &&
           color::colorDistance(color::medianColor(sample.colors), own) < kSameColorDistance;
  });
  return alike;
}

/// Nothing where the rays through the centers do not meet.
std::optional<PositionCorrection> correctionFrom(const std::vector<PointClick>& centers,
                                                 const CameraRig& rig, std::int64_t frame,
                                                 int target) {
  if (centers.empty()) {
    return std::nullopt;
  }
  const auto position = positionFromClicks(rig, centers, std::nullopt);
  if (!position) {
    return std::nullopt;
  }
  return PositionCorrection{frame, target, position->mean, position->covariance, centers};
}

/// What samples in the images of one frame lead to in the other cameras.
class FoundSamples {
public:
  FoundSamples(const ClickedImages& shown, ClickLearningResult& result)
      : shown_(shown), result_(result), undecided_(shown.images.size()) {}

  void add(const ColorSample& click, const Counterparts& counterparts) {
    clicks_.push_back(click);
    const std::size_t colors = color::groupSamplesByColor(clicks_).size();
    if (result_.centers.empty()) {
      result_.radius = counterparts.radius;
      result_.centers = counterparts.centers;
    } else if (colors > colors_) {
      join(counterparts);
    }
    colors_ = colors;
    for (std::size_t i = 0; i < counterparts.samples.size(); ++i) {
      ColorSample sample = counterparts.samples[i];
      if (!showsTarget(result_.samples, sample.camera, shown_.frame) ||
          (colors > 1 && !showsColor(sample))) {
        sample.frame = shown_.frame;
        result_.outlines.push_back({sample.camera, counterparts.outlines[i]});
        result_.samples.push_back(std::move(sample));
      }
    }
    for (std::size_t camera = 0; camera < undecided_.size(); ++camera) {
      unite(counterparts.undecidedMasks[camera], undecided_[camera]);
    }
  }

  /// Pixels that may show the target, where no sample says what does.
  std::vector<cv::Mat> undecided() const {
    std::vector<cv::Mat> masks = undecided_;
    for (std::size_t camera = 0; camera < masks.size(); ++camera) {
      if (showsTarget(result_.samples, static_cast<int>(camera), shown_.frame)) {
        masks[camera].release();
      }
    }
    return masks;
  }

private:
  /// Whether a sample in the same image shows the target in about this color: the sides of a target
  /// of several colors are found one by one.
  bool showsColor(const ColorSample& found) const {
    const BgrColor own = color::medianColor(found.colors);
    return std::ranges::any_of(result_.samples, [&](const ColorSample& sample) {
      return !sample.isExcluded && sample.camera == found.camera && sample.frame == shown_.frame &&
             color::colorDistance(color::medianColor(sample.colors), own) < kSameColorDistance;
    });
  }

  /// Another color of the same thing: its region is a further part of its outline.
  void join(const Counterparts& part) {
    if (!result_.radius || !part.radius) {
      return;
    }
    const double share =
        std::pow(*part.radius, 2) / (std::pow(*result_.radius, 2) + std::pow(*part.radius, 2));
    for (PointClick& center : result_.centers) {
      const auto same = std::ranges::find(part.centers, center.camera, &PointClick::camera);
      if (same != part.centers.end()) {
        center.pixel += share * (same->pixel - center.pixel);
      }
    }
    result_.radius = std::hypot(*result_.radius, *part.radius);
  }

  const ClickedImages& shown_;
  ClickLearningResult& result_;
  std::vector<cv::Mat> undecided_;
  std::vector<ColorSample> clicks_; ///< on the target, in these images
  std::size_t colors_ = 0;          ///< that they show
};

/// What a click or box marks, if it is only a part of something larger. The other cameras are
/// searched for the whole thing then.
struct Marked {
  std::optional<PartMark> part;
  Counterparts counterparts;
};

Marked searchedFor(const CameraRig& rig, const std::vector<cv::Mat>& images,
                   const ColorSample& sample, const CounterpartLimits& limits) {
  const auto camera = static_cast<std::size_t>(sample.camera);
  if (sample.camera < 0 || camera >= images.size() || camera >= rig.size()) {
    return {std::nullopt, findCounterparts(rig, images, sample, limits)};
  }
  Marked marked;
  marked.part = partInBox(images[camera], sample);
  if (marked.part && !findClickedObject(rig.at(camera), images[camera], marked.part->wholeObject)) {
    marked.part.reset(); // a wall, or a region that grew too far
  }
  if (marked.part) {
    CounterpartLimits ofWhole = limits;
    ofWhole.radius = 0.0;
    marked.counterparts = findCounterparts(rig, images, marked.part->wholeObject, ofWhole);
    return marked;
  }
  marked.counterparts = findCounterparts(rig, images, sample, limits);
  if (limits.radius > 0.0 && marked.counterparts.radius) {
    const double wholePx = std::sqrt(sample.areaPx / std::numbers::pi);
    marked.part =
        partAtClick(images[camera], sample, wholePx * limits.radius / *marked.counterparts.radius);
  }
  return marked;
}

} // namespace

Result<ClickLearningResult> learnFromClicks(const CameraRig& rig, const ClickedImages& shown,
                                            const std::vector<ColorSample>& samples,
                                            const CounterpartLimits& limits,
                                            const std::vector<ColorSample>& others) {
  ClickLearningResult result;
  result.samples = reorderedSamples(samples, shown.frame);
  const std::vector<ColorSample> alike = samplesOfSameColor(others, samples, shown.frame);
  CounterpartLimits known = limits;
  known.excludedSamples.insert(known.excludedSamples.end(), alike.begin(), alike.end());
  std::ranges::copy_if(
      samples, std::back_inserter(known.excludedSamples),
      [&](const ColorSample& sample) { return sample.isExcluded && sample.frame == shown.frame; });
  FoundSamples found(shown, result);
  std::vector<PartMark> parts;
  std::vector<ColorSample> wholes;
  for (const ColorSample& sample : samples) {
    if (isClick(sample) && sample.frame == shown.frame) {
      const Marked marked = searchedFor(rig, shown.images, sample, known);
      found.add(sample, marked.counterparts);
      if (marked.part) {
        parts.push_back(*marked.part);
        wholes.insert(wholes.end(), marked.counterparts.samples.begin(),
                      marked.counterparts.samples.end());
      }
    }
  }
  result.part = locatePart(rig, shown.images, parts, wholes);
  if (result.part) {
    result.radius = result.part->radius;
  }
  std::vector<cv::Mat> undecided = found.undecided();
  for (const ColorSample& sample : alike) {
    const auto camera = static_cast<std::size_t>(sample.camera);
    if (camera < undecided.size() && shown.images[camera].type() == CV_8UC3) {
      unite(color::regionOfSample(shown.images[camera], sample), undecided[camera]);
    }
  }
  return color::learnColorWithBackground(result.samples, shown.images, shown.backgroundImages,
                                         undecided)
      .map([&](const LearnedColor& learned) {
        result.color = learned;
        return result;
      });
}

Result<ClickLearningResult> learnFromClicks(const Project& project, int target,
                                            const ClickedImages& shown,
                                            const std::vector<ColorSample>& samples) {
  CounterpartLimits limits;
  limits.volume = project.volumeOfInterest;
  std::vector<ColorSample> others;
  for (int i = 0; i < static_cast<int>(project.targets.size()); ++i) {
    const Target& one = project.targets[static_cast<std::size_t>(i)];
    if (i == target) {
      limits.radius = one.radius;
    } else {
      others.insert(others.end(), one.samples.begin(), one.samples.end());
    }
  }
  const CameraRig rig = rigOf(project);
  const bool isNew = target < 0 || target >= static_cast<int>(project.targets.size());
  const int index = isNew ? static_cast<int>(project.targets.size()) : target;
  auto result = learnFromClicks(rig, shown, samples, limits, others);
  if (result && result->part) {
    const MarkedPart& part = *result->part;
    result->correction = PositionCorrection{shown.frame, index, part.position.mean,
                                            part.position.covariance, part.clicks};
  } else if (result && (!result->color.assessment.distractors.empty() ||
                        !samplesOfSameColor(others, samples, shown.frame).empty())) {
    result->correction = correctionFrom(result->centers, rig, shown.frame, index);
  }
  return result;
}

void applyLearningResult(const ClickLearningResult& result, std::size_t target, Project& project) {
  Target& taught = project.targets.at(target);
  const auto index = static_cast<int>(target);
  for (const ColorSample& sample : taught.samples) {
    if (isClick(sample) && std::ranges::count(result.samples, sample) == 0) {
      removeCorrection(project, sample.frame, index);
    }
  }
  taught.color = result.color.range;
  taught.otherColors = result.color.otherRanges;
  taught.samples = result.samples;
  if (result.part && taught.radius <= 0.0) {
    constexpr double kRadiusStep = 1e-4; // meters: finer is not known
    taught.radius = kRadiusStep * std::max(1.0, std::round(result.part->radius / kRadiusStep));
  }
  if (!result.correction) {
    return;
  }
  const PositionCorrection* present = correctionAt(project, result.correction->frame, index);
  const bool marksMore = present != nullptr && result.part &&
                         present->clicks.size() < result.correction->clicks.size();
  if (present == nullptr || marksMore) {
    PositionCorrection correction = *result.correction;
    correction.target = index;
    addCorrection(project, correction);
  }
}

RadiusFit compareRadius(double given, double shown) {
  // Factors between the two. Judgments: regions show a radius to a third, and a diameter is two.
  constexpr double kSameColorDistance = 1.6;
  constexpr double kMostOfDiameter = 2.6;
  const double ratio = given / shown;
  if (ratio > 1.0 / kSameColorDistance && ratio < kSameColorDistance) {
    return RadiusFit::Fits;
  }
  return ratio >= kSameColorDistance && ratio < kMostOfDiameter ? RadiusFit::IsDiameter
                                                                : RadiusFit::Differs;
}

std::vector<ColorSample> withoutSample(std::vector<ColorSample> samples, std::size_t index) {
  ColorSample& sample = samples.at(index);
  if (sample.isFoundByGeometry) {
    sample.isFoundByGeometry = false;
    sample.isExcluded = true;
  } else {
    samples.erase(samples.begin() + static_cast<std::ptrdiff_t>(index));
  }
  return samples;
}

bool hasClickedSample(const std::vector<ColorSample>& samples) {
  return std::ranges::any_of(samples, isClick);
}

} // namespace dewpoint::setup
