// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
enum class ColorWord : std::uint8_t {
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

/// The everyday name of a color.
ColorWord colorWord(const BgrColor& color);

/// Something that is not the target and matches its color too.
struct DistractorRegion {
  int camera = 0;
  cv::Rect box;
  double share = 0.0; ///< of the image's pixels
  std::vector<cv::Point> outline;
  HorizontalThird horizontal = HorizontalThird::Center; ///< thirds of the image
  VerticalThird vertical = VerticalThird::Middle;
  ColorWord color = ColorWord::Gray;
};

/// What the user can do about it.
enum class Suggestion : std::uint8_t {
  None,              ///< the color separates well
  AddSamples,        ///< much of the target does not match: click its light and its dark side
  ExcludeDistractor, ///< one object matches that could be excluded: Alt-click it
  RemoveDistractor,  ///< one object of the same color: cover it or take it out of view
  MoreLight,         ///< the target is nearly black
  LessExposure,      ///< the target is nearly white: its color is lost
  UseStrongerColor,  ///< the target is nearly gray
  UseAnotherColor,   ///< several objects in the room have this color
  FollowAll,         ///< a few objects of this color and size: each may be a target (`alike`)
  ClickObjectItself, ///< what was clicked fills much of an image: a wall, not an object
  ClickMore,         ///< what was clicked is a speck, of which little matches
};

/// How well a color range distinguishes the target from the rest.
struct ColorAssessment {
  /// False when there is no sample: then nothing but backgroundShare, of all pixels, is known.
  bool targetKnown = true;
  /// F1 score of the range, 0 to 1: of what matches and what is target, the share that is both.
  /// The samples stand for the target, what is around them in the images for the rest.
  double separability = 0.0;
  double targetShare = 0.0;     ///< share of the sampled colors that match
  double backgroundShare = 0.0; ///< share of the other pixels that match too
  /// backgroundShare of a range for the whole target. Where little of it matches, this is why: more
  /// of it would cost more than it wins. Nothing while missesTarget() is false.
  std::optional<double> backgroundShareOfWhole;
  std::vector<DistractorRegion> distractors; ///< largest first, at most kMostDistractors
  /// Objects of the target's color and about its size in one image, the target among them.
  int alike = 1;
  /// A sample hardly matches what was found for all.
  bool sampleLeftOut = false;
  Suggestion suggestion = Suggestion::None;

  /// Distractors that are listed.
  static constexpr std::size_t kMostDistractors = 5;
  static constexpr double kFewMatch = 0.75; ///< of the target

  /// The separability as it is shown, 0 to 100.
  int score() const { return static_cast<int>(std::lround(100.0 * separability)); }
  /// Whether the score is low, or lower, because much of the target does not match.
  bool missesTarget() const { return targetKnown && targetShare < kFewMatch; }
};

/// How well a color does on the evidence that was collected from these images.
ColorAssessment assessRange(const ColorRanges& ranges, const ColorEvidence& evidence,
                            const std::vector<cv::Mat>& images);

} // namespace dewpoint::color
