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
/// Everyday names of colors.
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

/// Returns the everyday name of a color.
ColorWord colorWord(const BgrColor& color);

/// A region that is not the target but also matches its color: a distractor.
struct DistractorRegion {
  int camera = 0;
  cv::Rect box;
  double share = 0.0; ///< share of the image's pixels, 0 to 1
  std::vector<cv::Point> outline;
  HorizontalThird horizontal = HorizontalThird::Center; ///< position in the image, in thirds
  VerticalThird vertical = VerticalThird::Middle;
  ColorWord color = ColorWord::Gray;
};

/// Suggestion to the user for improving the color.
enum class Suggestion : std::uint8_t {
  None,              ///< none: the color separates well
  AddSamples,        ///< much of the target does not match: click its light and its dark side
  ExcludeDistractor, ///< one object matches and can be excluded: Alt-click it
  RemoveDistractor,  ///< one object has the same color: cover it or move it out of view
  MoreLight,         ///< the target is nearly black
  LessExposure,      ///< the target is nearly white: its color is lost
  UseStrongerColor,  ///< the target is nearly gray
  UseAnotherColor,   ///< several objects in the room have this color
  FollowAll,         ///< a few objects have this color and size: each may be a target (`alike`)
  ClickObjectItself, ///< the clicked region fills much of an image: a wall, not an object
  ClickMore,         ///< the clicked region is tiny, and little of it matches
};

/// Assessment of how well a color range distinguishes the target from everything else.
struct ColorAssessment {
  /// False if there is no sample: then only backgroundShare is known, as a share of all pixels.
  bool targetKnown = true;
  /// F1 score of the range, 0 to 1: 2 precision recall / (precision + recall). The samples stand
  /// for the target, the rest of the images for the background.
  double separability = 0.0;
  double targetShare = 0.0;     ///< share of the sampled colors that match, 0 to 1
  double backgroundShare = 0.0; ///< share of the other pixels that match too, 0 to 1
  /// backgroundShare of a range that covers the whole target. If little of the target matches, it
  /// shows why: covering more of the target would match too much background. Nothing while
  /// missesTarget() is false.
  std::optional<double> backgroundShareOfWhole;
  std::vector<DistractorRegion> distractors; ///< largest first, at most kMostDistractors
  /// Number of objects in one image with the target's color and about its size, the target
  /// included.
  int alike = 1;
  /// Whether some sample hardly matches the range that was found for all samples.
  bool sampleLeftOut = false;
  Suggestion suggestion = Suggestion::None;

  /// Maximum number of distractors in the list.
  static constexpr std::size_t kMostDistractors = 5;
  static constexpr double kFewMatch =
      0.75; ///< share of the target below which missesTarget() is true

  /// The separability as it is shown, 0 to 100.
  int score() const { return static_cast<int>(std::lround(inPercent(separability))); }
  /// Whether the score is low, or lower, because much of the target does not match.
  bool missesTarget() const { return targetKnown && targetShare < kFewMatch; }
};

/// Assesses color ranges by the evidence that was collected from these images.
ColorAssessment assessRange(const ColorRanges& ranges, const ColorEvidence& evidence,
                            const std::vector<cv::Mat>& images);

} // namespace dewpoint::color
