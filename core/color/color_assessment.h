// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/units.h"
#include "core/color/color_ranges.h"
#include "core/color/color_sample.h"

#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace dewpoint::color {

struct ColorEvidence;

enum class HorizontalThird : std::uint8_t { Left, Center, Right };
enum class VerticalThird : std::uint8_t { Top, Middle, Bottom };
/// Common names of colors.
enum class ColorName : std::uint8_t {
  Black,
  Gray,
  White,
  Brown,
  Red,
  Orange,
  Yellow,
  Green,
  Turquoise,
  Blue,
  Purple,
  Pink,
};

/// Returns the common name of a color.
ColorName nameOfColor(const BgrColor& color);

/// Distractor: a region of an image that matches the target's color but is not the target.
struct DistractorRegion {
  int camera = 0;
  cv::Rect box;
  double shareOfImage = 0.0; ///< fraction of the image's pixels, 0 to 1
  std::vector<cv::Point> outline;
  HorizontalThird horizontalThird = HorizontalThird::Center; ///< position in the image, by thirds
  VerticalThird verticalThird = VerticalThird::Middle;
  ColorName color = ColorName::Gray;
};

/// Suggestion to the user for improving the color.
enum class ColorSuggestion : std::uint8_t {
  None,              ///< no suggestion: the color separates well
  AddSamples,        ///< much of the target does not match: click its light and dark sides
  ExcludeDistractor, ///< one object matches and can be excluded: Alt-click it
  RemoveDistractor,  ///< one object has the same color: cover it or move it out of view
  MoreLight,         ///< the target is nearly black
  LessExposure,      ///< the target is nearly white, so its color is lost
  UseStrongerColor,  ///< the target is nearly gray
  UseAnotherColor,   ///< several objects in the room have this color
  /// A few objects (ColorAssessment::similarObjectCount) have this color and size: each may be a
  /// target.
  FollowAll,
  ClickObjectItself, ///< the clicked region fills much of an image: a wall, not an object
  ClickMore,         ///< the clicked region is tiny, and little of it matches
};

/// Assessment of how well color ranges distinguish the target from everything else.
struct ColorAssessment {
  /// False if there are no samples. In that case only backgroundShare is known, as a fraction of
  /// all pixels.
  bool isTargetKnown = true;
  /// F1 score of the range, 0 to 1: 2 * precision * recall / (precision + recall). The samples
  /// represent the target, and the rest of the images represents the background.
  double separability = 0.0;
  double targetShare = 0.0;     ///< fraction of the sampled colors that match, 0 to 1
  double backgroundShare = 0.0; ///< fraction of the other pixels that match as well, 0 to 1
  /// Fraction of the background pixels that would match if the range covered the whole target. This
  /// value shows the user why the learned range covers so little of the target: a wider range would
  /// match too much of the background. Empty if enough of the target matches (missesTarget() is
  /// false).
  std::optional<double> backgroundShareOfFullRange;
  std::vector<DistractorRegion> distractors; ///< largest first, at most kMaxDistractors
  /// Number of objects with the target's color and about the target's size, including the target,
  /// in the image that shows most such objects.
  int similarObjectCount = 1;
  /// True if there are several samples, and the ranges match almost no color of at least one
  /// sample.
  bool isSampleLeftOut = false;
  ColorSuggestion suggestion = ColorSuggestion::None;

  /// Maximum number of distractors in the list.
  static constexpr std::size_t kMaxDistractors = 5;
  /// Least fraction of the sampled colors that must match; below it, missesTarget() is true.
  static constexpr double kMinTargetShare = 0.75;
  static constexpr int kGoodScore = 90; ///< least score() at which isGood() is true

  /// Returns the separability (F1 score) in percent, as displayed: 0 to 100.
  int score() const { return static_cast<int>(std::lround(inPercent(separability))); }
  /// Returns whether the color separates the target well from the background: the background has
  /// few matching pixels compared with the target. Their positions do not matter.
  bool isGood() const { return isTargetKnown && score() >= kGoodScore; }
  /// Returns whether much of the target does not match, which lowers the score.
  bool missesTarget() const { return isTargetKnown && targetShare < kMinTargetShare; }
};

/// Returns the assessment of color ranges, based on evidence that was collected from `images`.
ColorAssessment assessRange(const ColorRanges& ranges, const ColorEvidence& evidence,
                            const std::vector<cv::Mat>& images);

} // namespace dewpoint::color
