// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/click_lesson.h"

#include "core/project/project_rig.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace dewpoint::setup {
namespace {

bool isClick(const ColorSample& sample) {
  return !sample.excluded && !sample.found;
}

bool hasClickAt(const std::vector<ColorSample>& samples, std::int64_t frame) {
  return std::ranges::any_of(
      samples, [&](const ColorSample& sample) { return isClick(sample) && sample.frame == frame; });
}

/// Whether there is one of this camera in the images of a frame.
bool showsTarget(const std::vector<ColorSample>& samples, int camera, std::int64_t frame) {
  return std::ranges::any_of(samples, [&](const ColorSample& sample) {
    return !sample.excluded && sample.camera == camera && sample.frame == frame;
  });
}

/// Puts clicks and exclusions first, and behind them what was found in other frames than `frame`.
std::vector<ColorSample> keptSamples(const std::vector<ColorSample>& samples, std::int64_t frame) {
  std::vector<ColorSample> kept;
  std::ranges::copy_if(samples, std::back_inserter(kept),
                       [](const ColorSample& sample) { return !sample.found; });
  std::ranges::copy_if(samples, std::back_inserter(kept), [&](const ColorSample& sample) {
    return sample.found && sample.frame != frame && hasClickAt(samples, sample.frame);
  });
  return kept;
}

/// What samples in the images of one frame lead to in the other cameras.
class FoundSamples {
public:
  FoundSamples(const ClickedImages& shown, ClickLesson& lesson)
      : shown_(shown), lesson_(lesson), undecided_(shown.images.size()) {}

  void add(Counterparts counterparts) {
    lesson_.radius = lesson_.radius ? lesson_.radius : counterparts.radius;
    for (std::size_t i = 0; i < counterparts.found.size(); ++i) {
      ColorSample& sample = counterparts.found[i];
      if (!showsTarget(lesson_.samples, sample.camera, shown_.frame)) {
        sample.frame = shown_.frame;
        lesson_.found.push_back({sample.camera, std::move(counterparts.outlines[i])});
        lesson_.samples.push_back(std::move(sample));
      }
    }
    for (std::size_t camera = 0; camera < undecided_.size(); ++camera) {
      const cv::Mat& mask = counterparts.undecided[camera];
      if (!mask.empty()) {
        undecided_[camera] = undecided_[camera].empty() ? mask : cv::Mat(undecided_[camera] | mask);
      }
    }
  }

  /// Pixels that may show the target, where no sample says what does.
  std::vector<cv::Mat> undecided() const {
    std::vector<cv::Mat> masks = undecided_;
    for (std::size_t camera = 0; camera < masks.size(); ++camera) {
      if (showsTarget(lesson_.samples, static_cast<int>(camera), shown_.frame)) {
        masks[camera].release();
      }
    }
    return masks;
  }

private:
  const ClickedImages& shown_;
  ClickLesson& lesson_;
  std::vector<cv::Mat> undecided_;
};

} // namespace

Result<ClickLesson> learnFromClicks(const CameraRig& rig, const ClickedImages& shown,
                                    const std::vector<ColorSample>& samples,
                                    const CounterpartLimits& limits) {
  ClickLesson lesson;
  lesson.samples = keptSamples(samples, shown.frame);
  CounterpartLimits known = limits;
  std::ranges::copy_if(samples, std::back_inserter(known.excluded), [&](const ColorSample& sample) {
    return sample.excluded && sample.frame == shown.frame;
  });
  FoundSamples found(shown, lesson);
  for (const ColorSample& sample : samples) {
    if (isClick(sample) && sample.frame == shown.frame) {
      found.add(findCounterparts(rig, shown.images, sample, known));
    }
  }
  return color::learnColorWithBackground(lesson.samples, shown.images, shown.emptyRooms,
                                         found.undecided())
      .map([&](const LearnedColor& learned) {
        lesson.color = learned;
        return lesson;
      });
}

Result<ClickLesson> learnFromClicks(const Project& project, const ClickedImages& shown,
                                    const std::vector<ColorSample>& samples,
                                    const CounterpartLimits& limits) {
  return learnFromClicks(rigOf(project), shown, samples, limits);
}

CounterpartLimits limitsOf(const Project& project, int target) {
  CounterpartLimits limits;
  limits.volume = project.volumeOfInterest;
  if (target >= 0 && target < static_cast<int>(project.targets.size())) {
    limits.radius = project.targets[static_cast<std::size_t>(target)].radius;
  }
  return limits;
}

RadiusFit compareRadius(double given, double shown) {
  // Factors between the two. Judgments: regions show a radius to a third, and a diameter is two.
  constexpr double kAlike = 1.6;
  constexpr double kMostOfDiameter = 2.6;
  const double ratio = given / shown;
  if (ratio > 1.0 / kAlike && ratio < kAlike) {
    return RadiusFit::Fits;
  }
  return ratio >= kAlike && ratio < kMostOfDiameter ? RadiusFit::IsDiameter : RadiusFit::Differs;
}

std::vector<ColorSample> withoutSample(std::vector<ColorSample> samples, std::size_t index) {
  ColorSample& sample = samples.at(index);
  if (sample.found) {
    sample.found = false;
    sample.excluded = true;
  } else {
    samples.erase(samples.begin() + static_cast<std::ptrdiff_t>(index));
  }
  return samples;
}

bool anyClicked(const std::vector<ColorSample>& samples) {
  return std::ranges::any_of(samples, isClick);
}

} // namespace dewpoint::setup
