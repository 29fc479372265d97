// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"
#include "core/color/color_sample.h"
#include "core/color/hsi_counts.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::color {

/// What one image shows of the target. Masks are CV_8UC1 of its size, 255 or 0; all is empty where
/// there is no image.
struct ImageEvidence {
  cv::Mat image;   ///< pixels are shared, not copied
  cv::Mat clicked; ///< where it still shows what was clicked; empty when no click does
  cv::Mat similar; ///< where no click does: the object of the samples' typical colors
  /// Where the target may be, so that these pixels are no evidence; empty: nowhere.
  cv::Mat undecided;
};

/// The steps that collecting evidence took.
struct EvidenceWork {
  int growths = 0; ///< regions grown from samples
  int floods = 0;  ///< times that an image was divided into the objects that match
  int counts = 0;  ///< images whose pixels were counted, all of them or some
};

/// The evidence of samples and images about a color: what is target, and what is not. Weights are
/// pixels.
struct ColorEvidence {
  std::vector<HsiColors> target;
  /// The same divided into the colors that the samples show, where that is more than one
  /// (colorsOfSamples()).
  std::vector<std::vector<HsiColors>> targetByColor;
  std::vector<HsiColors> rest;
  double targetWeight = 0.0;
  double restWeight = 0.0;
  double targetArea = 0.0; ///< mean pixels of the samples: how large the target is in an image
  double imageShare = 0.0; ///< of the smallest image that targetArea takes, 0 to 1
  BgrColor typicalColor{}; ///< the median of what was sampled
  /// Per camera, CV_8UC1: 255 where the target is or may be, so that it is no evidence about the
  /// rest. Empty where there is no image.
  std::vector<cv::Mat> targetMasks;

  // What later evidence of the same samples is collected from.
  std::int64_t views = 0;                      ///< cameras with an image
  ColorRanges typicalRanges = ColorRange{};    ///< of the target's colors alone
  std::vector<ImageEvidence> images;           ///< per camera
  std::shared_ptr<const HsiCounts> restCounts; ///< those of `rest`
  EvidenceWork work;                           ///< what it took
};

/// The target in an image is the region grown from a click, where the image still shows the clicked
/// object; elsewhere the one connected object of its color that is about as large. With `ranges`,
/// all parts of that object that match them belong to the target. What is `undecided` (per camera,
/// as ImageEvidence::undecided; fewer than cameras: nothing in the others) is no evidence about the
/// rest.
ColorEvidence colorEvidence(const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images,
                            const std::optional<ColorRanges>& ranges = std::nullopt,
                            const std::vector<cv::Mat>& undecided = {});

/// The same bits as colorEvidence(samples, images, ranges, undecided), from what was collected
/// `before` of the same samples with the same undecided pixels, which have to be of the same size
/// as the images still. Regions are grown only in images that have other pixels by now, objects
/// that match the ranges are searched only where no click shows the target, and only pixels are
/// counted that are target in one and not in the other; with excluded samples all pixels are, once
/// any has changed.
ColorEvidence colorEvidence(const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images, const ColorRanges& ranges,
                            const ColorEvidence& before);

/// The target's colors as other positions and times will show them: lighter and darker, paler and
/// fuller, a little of another hue. The weight stays.
std::vector<HsiColors> inOtherLight(const std::vector<HsiColors>& colors);

} // namespace dewpoint::color
