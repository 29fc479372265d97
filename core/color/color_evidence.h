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

/// Evidence from one image: the pixels that show the target or may show the target. Masks are
/// CV_8UC1 with the size of the image, containing 255 or 0. All members are empty if there is no
/// image.
struct ImageEvidence {
  cv::Mat image; ///< shares the pixels of the input
  /// Region of the clicked object if the image still shows this object; otherwise empty.
  cv::Mat clickedMask;
  /// Mask of the pixels that most likely belong to the target, according to the typical colors of
  /// the samples. Computed only if `clickedMask` is empty; otherwise empty.
  cv::Mat similarColorMask;
  /// Pixels that may show the target, and are therefore not counted as the rest of the image; may
  /// be empty.
  cv::Mat undecidedMask;
};

/// Cost of collecting evidence: how often each of the slow steps was done.
struct EvidenceWorkCounts {
  int grownRegionCount = 0;  ///< number of regions grown from samples
  int floodFillCount = 0;    ///< number of times an image was divided into matching objects
  int countedImageCount = 0; ///< number of images whose pixels were counted, all or some of them
};

/// Evidence from which a target color is learned: the colors of the target, and the colors of
/// everything else in the images (the rest). Weights are in pixels.
struct ColorEvidence {
  std::vector<WeightedHsiColor> targetColors;
  /// Colors of the target (`targetColors`), split into one list for each separate color of the
  /// samples (groupSamplesByColor()). Empty if the samples have only one color.
  std::vector<std::vector<WeightedHsiColor>> targetColorsBySampleColor;
  std::vector<WeightedHsiColor> restColors;
  double targetWeight = 0.0;
  double restWeight = 0.0;
  /// Mean area of the samples in pixels, used as the size of the target in an image.
  double targetAreaPx = 0.0;
  double targetShareOfImage =
      0.0;                 ///< targetAreaPx as a fraction of the area of the smallest image, 0 to 1
  BgrColor typicalColor{}; ///< median of the sampled colors
  /// Masks per camera, CV_8UC1: 255 where a pixel shows or may show the target, so that it is not
  /// counted as the rest of the image. Empty where there is no image.
  std::vector<cv::Mat> targetMasks;

  // Data from which later evidence for the same samples is computed.
  std::int64_t viewCount = 0;                  ///< number of cameras with an image
  ColorRanges typicalRanges = ColorRange{};    ///< ranges fitted to the target colors alone
  std::vector<ImageEvidence> images;           ///< evidence in the image of each camera
  std::shared_ptr<const HsiCounts> restCounts; ///< how often each color occurs in `restColors`
  EvidenceWorkCounts workCounts;               ///< cost of collecting this evidence
};

/// Collects evidence from samples and images. In an image that still shows a clicked object, the
/// target is the region grown from the click. In any other image, the target is the largest
/// connected region with the typical colors of the samples, if its size is plausible. With
/// `ranges`, regions of plausible size that match `ranges` and overlap this target are added to it.
/// If no region of plausible size has the typical colors, the target is the largest region of
/// plausible size that matches `ranges`.
///
/// `undecided` marks the pixels that are not counted as the rest of an image. `undecided` contains
/// a mask for each camera, as in ImageEvidence::undecidedMask, and may have fewer entries than
/// there are cameras.
ColorEvidence collectColorEvidence(const std::vector<ColorSample>& samples,
                                   const std::vector<cv::Mat>& images,
                                   const std::optional<ColorRanges>& ranges = std::nullopt,
                                   const std::vector<cv::Mat>& undecided = {});

/// Returns exactly the result of collectColorEvidence(samples, images, ranges, undecided), bit for
/// bit, but faster. `before` is earlier evidence for the same samples and the same undecided
/// pixels. The images must have the same sizes as before. Less work is needed for these reasons:
/// - Regions are grown only in images whose pixels have changed.
/// - Objects that match the ranges are searched for only in images in which no click shows the
///   target.
/// - In an unchanged image, only those pixels are counted that belong to the target in exactly one
///   of the two results.
///
/// If there are excluded samples and any image or its target has changed, all pixels of all images
/// are counted again.
ColorEvidence collectColorEvidence(const std::vector<ColorSample>& samples,
                                   const std::vector<cv::Mat>& images, const ColorRanges& ranges,
                                   const ColorEvidence& before);

/// Returns the target colors as they would appear at other positions and at other times: lighter
/// and darker, paler and more saturated, with slightly different hues. The total weight is
/// unchanged.
std::vector<WeightedHsiColor> withLightVariations(const std::vector<WeightedHsiColor>& colors);

} // namespace dewpoint::color
