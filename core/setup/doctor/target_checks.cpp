// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/doctor/target_checks.h"

#include "core/base/units.h"
#include "core/color/match_image.h"
#include "core/color/target_exposure.h"
#include "core/tracking/catalog/method_catalog.h"

#include <fmt/format.h>
#include <opencv2/core.hpp>

#include <algorithm>
#include <vector>

namespace dewpoint::setup {
namespace {

/// Share of a camera's images above which a color is rather that of the surroundings.
constexpr double kMaxColorCover = 0.5;
/// Pixels of a color in an image below which they are noise.
constexpr int kFewestPixels = 5;
/// Meters: balloons and beach balls are smaller, millimeters taken for meters larger.
constexpr double kLargestRadius = 1.5;
/// Steps of each channel in which colors are tried: every fourth value.
constexpr int kColorStep = 4;

std::string targetKey(std::size_t target, const char* key) {
  return fmt::format("target {}.{}", target + 1, key);
}

bool matchesAnything(const ColorClassifier& color) {
  for (int b = 0; b < 256; b += kColorStep) {
    for (int g = 0; g < 256; g += kColorStep) {
      for (int r = 0; r < 256; r += kColorStep) {
        if (color.matches(static_cast<std::uint8_t>(b), static_cast<std::uint8_t>(g),
                          static_cast<std::uint8_t>(r))) {
          return true;
        }
      }
    }
  }
  return false;
}

/// What a color covers of the images of one camera.
struct ColorCover {
  bool isSeen = false;
  double share = 0.0; ///< of all pixels
};

ColorCover coverOf(const CameraFootage& footage, const ColorClassifier& color) {
  ColorCover cover;
  double pixels = 0.0;
  double matching = 0.0;
  for (const cv::Mat& image : footage.images) {
    const int count = cv::countNonZero(matchImage(image, color));
    cover.isSeen = cover.isSeen || count >= kFewestPixels;
    matching += count;
    pixels += static_cast<double>(image.total());
  }
  cover.share = pixels > 0.0 ? matching / pixels : 0.0;
  return cover;
}

void checkColorInImages(Examination& examination, std::size_t number,
                        const ColorClassifier& color) {
  const Target& target = examination.project.targets[number];
  const std::string field = targetKey(number, "hue");
  std::size_t images = 0;
  double share = 0.0;
  std::size_t cameras = 0;
  std::vector<std::size_t> unseen;
  for (std::size_t k = 0; k < examination.footage.size(); ++k) {
    const CameraFootage& footage = examination.footage[k];
    if (footage.images.empty()) {
      continue;
    }
    ++cameras;
    images += footage.images.size();
    const ColorCover cover = coverOf(footage, color);
    share += cover.share;
    if (cover.share > kMaxColorCover) {
      examination.add(
          FindingKind::ColorEverywhere,
          {target.name, fmt::format("{:.0f}", inPercent(cover.share)), examination.nameOf(k)},
          field);
      return;
    }
    if (!cover.isSeen) {
      unseen.push_back(k);
    }
  }
  if (cameras == 0) {
    return;
  }
  if (unseen.size() == cameras) {
    examination.add(FindingKind::ColorNowhere, {target.name, std::to_string(images)}, field);
    return;
  }
  for (const std::size_t k : unseen) {
    examination.add(FindingKind::ColorNotInCamera, {target.name, examination.nameOf(k)}, field);
  }
  if (unseen.empty()) {
    examination.add(
        FindingKind::ColorFine,
        {target.name, fmt::format("{:.2g}", inPercent(share / static_cast<double>(cameras)))},
        field);
  }
}

/// By the samples: they are as the images were when the color was learned.
void checkExposure(Examination& examination, std::size_t number) {
  const Target& target = examination.project.targets[number];
  std::vector<TargetExposure> exposures(examination.footage.size());
  for (const ColorSample& sample : target.samples) {
    const auto camera = static_cast<std::size_t>(sample.camera);
    for (std::size_t k = 0;
         !sample.isExcluded && camera < exposures.size() && k < sample.colors.size(); ++k) {
      exposures[camera].add(sample.colors[k]);
    }
  }
  for (std::size_t camera = 0; camera < exposures.size(); ++camera) {
    const TargetExposure& exposure = exposures[camera];
    if (const ExposureFault fault = exposure.fault(); fault != ExposureFault::None) {
      const bool isOver = fault == ExposureFault::Overexposed;
      const double share = isOver ? exposure.clippedShare() : exposure.darkShare();
      examination.add(
          isOver ? FindingKind::TargetOverexposed : FindingKind::TargetTooDark,
          {target.name, fmt::format("{:.0f}", inPercent(share)), examination.nameOf(camera)},
          targetKey(number, "sample"));
    }
  }
}

void checkColor(Examination& examination, std::size_t number) {
  const Target& target = examination.project.targets[number];
  if (target.color == ColorRange() && target.otherColors.empty()) {
    examination.add(FindingKind::ColorNotLearned, {target.name}, targetKey(number, "hue"));
    return;
  }
  const ColorClassifier color(target.colors());
  if (!matchesAnything(color)) {
    examination.add(FindingKind::ColorMatchesNothing, {target.name}, targetKey(number, "hue"));
    return;
  }
  checkColorInImages(examination, number, color);
}

/// The first frame that is not there any more; 0: unknown.
std::int64_t endOf(const Examination& examination, int camera) {
  const auto index = static_cast<std::size_t>(camera);
  return index < examination.footage.size() ? examination.footage[index].frameCount : 0;
}

/// Whether the method can track a target only with its box.
bool needsBox(const MethodFamily& family, Target target) {
  target.box.reset();
  return !family.isDefined(target);
}

void checkBoxOf(Examination& examination, std::size_t number) {
  const Target& target = examination.project.targets[number];
  if (!target.box) {
    examination.add(FindingKind::BoxMissing, {target.name}, targetKey(number, "box"));
    return;
  }
  const std::int64_t end = endOf(examination, target.box->camera);
  if (end > 0 && target.box->frame >= end) {
    examination.add(FindingKind::BoxTooLate,
                    {target.name, std::to_string(target.box->frame), std::to_string(end - 1)},
                    targetKey(number, "box.frame"));
  }
}

} // namespace

void checkTargets(Examination& examination) {
  const Project& project = examination.project;
  const MethodFamily family = methodFamily(project.method);
  if (family.lacksTargets(project.targets)) {
    examination.add(FindingKind::TargetsMissing, {family.noTargetsText(project.method)}, "target");
  }
  for (std::size_t k = 0; k < project.targets.size(); ++k) {
    if (needsBox(family, project.targets[k])) {
      checkBoxOf(examination, k);
    }
    if (!family.hasColorMasks()) {
      continue;
    }
    if (project.targets[k].radius > kLargestRadius) {
      examination.add(FindingKind::RadiusUnlikely,
                      {project.targets[k].name, fmt::format("{:g}", project.targets[k].radius)},
                      targetKey(k, "radius"));
    }
    checkColor(examination, k);
    checkExposure(examination, k);
  }
}

} // namespace dewpoint::setup
