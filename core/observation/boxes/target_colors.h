// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/boxes/fine_histogram.h"

#include <array>
#include <cstdint>
#include <vector>

namespace dewpoint::observation {

/// For each color bin, max(0, 2 P - 1) in units of 1 / kWhole, P being the probability that a pixel
/// of that color belongs to the target: 0 where the color is as likely in the surroundings.
using BinShares = std::vector<std::uint16_t>;

/// What colors the parts of a boxed target have, and what colors are around it. The histograms
/// follow slow changes, the target's by half its way only: the first image stays an anchor.
class TargetColors {
public:
  static constexpr int kColumns = 2;
  static constexpr int kRows = 3;
  static constexpr int kParts = kColumns * kRows;
  static constexpr std::uint16_t kWhole = 256;

  /// Forgets everything and takes the colors of a box (its center in the image).
  void learn(const cv::Mat& bgr, const ImageBox& box);
  /// Moves the histograms towards those of a box by `rate`, [0, 1]. Pixels of colors that are
  /// rather the surroundings' count for less: ground that has got into the box is not learned.
  void adaptTarget(const cv::Mat& bgr, const ImageBox& box, double rate);
  void adaptSurroundings(const cv::Mat& bgr, const ImageBox& box, double rate);

  /// In a part (row by row from the upper left): max(0, 2 P(target | color) - 1), where P is the
  /// background-weighted ratio q² / (q² + b²) of the histograms of part and surroundings.
  BinShares shares(int part) const;

  /// How much a box speaks for the target as it was learned first, against the surroundings as they
  /// are now: the mean of max(0, 2 P - 1) over its pixels, [0, 1].
  double likeness(const cv::Mat& bgr, const ImageBox& box) const;

  /// About how many bytes a copy takes.
  std::size_t memoryBytes() const {
    return sizeof(double) * surroundings_.capacity() * (2 * kParts + 1); // all of one size
  }

  /// A part of a box.
  static ImageBox partOf(const ImageBox& box, int part);

private:
  FineHistogram figureOf(FineHistogram now, const FineHistogram& reference) const;

  std::array<FineHistogram, kParts> first_;
  std::array<FineHistogram, kParts> parts_;
  FineHistogram surroundings_;
};

} // namespace dewpoint::observation
