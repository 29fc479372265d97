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

/// Evidence about the target in one image. Masks are CV_8UC1 of the image's size, 255 or 0. All
/// members are empty if there is no image.
struct ImageEvidence {
  cv::Mat image;   ///< shares the pixels of the input
  cv::Mat clicked; ///< region in which the image still shows the clicked object; empty if no click
                   ///< shows it
  cv::Mat similar; ///< without a click: the object with the samples' typical colors
  /// Pixels that may show the target and are therefore no evidence about the rest; empty: none.
  cv::Mat undecided;
};

/// Number of steps that collecting evidence took, by kind.
struct EvidenceWork {
  int growths = 0; ///< number of regions grown from samples
  int floods = 0;  ///< number of times that an image was divided into matching objects
  int counts = 0;  ///< number of images in which all or some pixels were counted
};

/// Evidence about a color from samples and images: colors of the target, and colors of everything
/// else (the rest). Weights are in pixels.
struct ColorEvidence {
  std::vector<HsiColors> target;
  /// Colors of the target, divided into the separate colors of the samples (colorsOfSamples());
  /// empty if the samples have only one color.
  std::vector<std::vector<HsiColors>> targetByColor;
  std::vector<HsiColors> rest;
  double targetWeight = 0.0;
  double restWeight = 0.0;
  double targetArea =
      0.0; ///< mean area of the samples in pixels: how large the target is in an image
  double imageShare = 0.0; ///< targetArea as a share of the smallest image, 0 to 1
  BgrColor typicalColor{}; ///< median of the sampled colors
  /// Masks per camera, CV_8UC1: 255 where the target is or may be, so that the pixel is no evidence
  /// about the rest. Empty where there is no image.
  std::vector<cv::Mat> targetMasks;

  // Data from which later evidence of the same samples is computed.
  std::int64_t views = 0;                      ///< number of cameras with an image
  ColorRanges typicalRanges = ColorRange{};    ///< ranges of the target's colors alone
  std::vector<ImageEvidence> images;           ///< per camera
  std::shared_ptr<const HsiCounts> restCounts; ///< counts of `rest`
  EvidenceWork work;                           ///< cost of collecting this evidence
};

/// Collects evidence from samples and images. In an image that still shows a clicked object, the
/// target is the region grown from the click; in other images it is the one connected object of its
/// color and about its size. With `ranges`, all parts of that object that match them belong to the
/// target. `undecided` (per camera, as ImageEvidence::undecided; may have fewer entries than
/// cameras) marks pixels that are no evidence about the rest.
ColorEvidence colorEvidence(const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images,
                            const std::optional<ColorRanges>& ranges = std::nullopt,
                            const std::vector<cv::Mat>& undecided = {});

/// Returns bit for bit the result of colorEvidence(samples, images, ranges, undecided), computed
/// faster from the evidence `before` of the same samples and undecided pixels. The images must have
/// the same sizes as before. Regions are grown only in images whose pixels have changed; objects
/// that match the ranges are searched only where no click shows the target; only pixels that belong
/// to the target in one of the two and not in the other are counted. With excluded samples, all
/// pixels are counted if any has changed.
ColorEvidence colorEvidence(const std::vector<ColorSample>& samples,
                            const std::vector<cv::Mat>& images, const ColorRanges& ranges,
                            const ColorEvidence& before);

/// Colors of the target as they appear in other positions and at other times: lighter and darker,
/// paler and more saturated, with a slightly different hue. The total weight stays the same.
std::vector<HsiColors> inOtherLight(const std::vector<HsiColors>& colors);

} // namespace dewpoint::color
