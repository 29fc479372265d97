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

/// Evidence about the target in one image. Masks are CV_8UC1 with the size of the image, containing
/// 255 or 0. All members are empty if there is no image.
struct ImageEvidence {
  cv::Mat image;   ///< shares the pixels of the input
  cv::Mat clicked; ///< region in which the image still shows the clicked object; empty if no click
                   ///< shows it
  cv::Mat similar; ///< without a click: the object with the typical colors of the samples
  /// Pixels that may show the target and are therefore not evidence about the rest; may be empty.
  cv::Mat undecided;
};

/// Number of steps used for collecting evidence, by type.
struct EvidenceCost {
  int growths = 0; ///< number of regions grown from samples
  int floods = 0;  ///< number of times an image was divided into matching objects
  int counts = 0;  ///< number of images in which all or some pixels were counted
};

/// Evidence about a color from samples and images: colors of the target, and colors of everything
/// else (the rest). Weights are in pixels.
struct ColorEvidence {
  std::vector<WeightedHsiColor> target;
  /// Target colors, divided into the separate colors of the samples (groupSamplesByColor()). Empty
  /// if the samples have only one color.
  std::vector<std::vector<WeightedHsiColor>> targetByColor;
  std::vector<WeightedHsiColor> rest;
  double targetWeight = 0.0;
  double restWeight = 0.0;
  double targetArea =
      0.0; ///< mean area of the samples in pixels, which is the size of the target in an image
  double imageShare = 0.0; ///< targetArea as a fraction of the smallest image, 0 to 1
  BgrColor typicalColor{}; ///< median of the sampled colors
  /// Masks per camera, CV_8UC1: 255 where a pixel shows or may show the target and is therefore not
  /// evidence about the rest. Empty where there is no image.
  std::vector<cv::Mat> targetMasks;

  // Data from which later evidence for the same samples is computed.
  std::int64_t views = 0;                      ///< number of cameras with an image
  ColorRanges typicalRanges = ColorRange{};    ///< ranges of the target colors alone
  std::vector<ImageEvidence> images;           ///< evidence in the image of each camera
  std::shared_ptr<const HsiCounts> restCounts; ///< counts of `rest`
  EvidenceCost work;                           ///< cost of collecting this evidence
};

/// Collects evidence from samples and images. In an image that still shows a clicked object, the
/// target is the region grown from the click. In other images, the target is the only connected
/// object with its color and about its size. With `ranges`, all parts of that object that match
/// them belong to the target. `undecided` marks pixels that are not evidence about the rest (per
/// camera, as in ImageEvidence::undecided; may have fewer entries than there are cameras).
ColorEvidence colorEvidence(const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images,
                            const std::optional<ColorRanges>& ranges = std::nullopt,
                            const std::vector<cv::Mat>& undecided = {});

/// Returns exactly the result of colorEvidence(samples, images, ranges, undecided), bit for bit,
/// but computes it faster from the evidence `before` for the same samples and undecided pixels. The
/// images must have the same sizes as before. Less work is needed for these reasons:
/// - Regions are grown only in images whose pixels have changed.
/// - Objects that match the ranges are searched only where no click shows the target.
/// - Pixels are counted only if they belong to the target in exactly one of the two results.
///
/// With excluded samples, all pixels are counted if any has changed.
ColorEvidence colorEvidence(const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images, const ColorRanges& ranges,
                            const ColorEvidence& before);

/// Returns the target colors as they appear in other positions and at other times: lighter and
/// darker, paler and more saturated, with slightly different hues. The total weight is unchanged.
std::vector<WeightedHsiColor> withLightVariations(const std::vector<WeightedHsiColor>& colors);

} // namespace dewpoint::color
