// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"
#include "core/color/hsi_counts.h"
#include "core/color/likelihood/color_cells.h"
#include "core/color/likelihood/color_likelihood.h"

#include <vector>

namespace dewpoint::color {

struct ColorEvidence;

/// How a camera shows colors beside the reference camera, which every other one is compared with:
/// factors of its gray levels, each > 0, by exposure (all alike) and white balance. Where gray
/// levels are a power of the light, a gain of light is a gain of gray levels too.
struct ColorGain {
  double blue = 1.0;
  double green = 1.0;
  double red = 1.0;

  bool operator==(const ColorGain&) const = default;
};

/// What is known of a target's color, common to all cameras: the colors it was seen in, and the HSI
/// range that a person sees and edits. The range is the prior, which decides about colors that were
/// never seen, and widened by a margin the limit, beyond which nothing counts as the target. All as
/// the reference camera shows it.
///
/// The table of a camera, by cell of color:
///   (1 - w) prior + w ln((t + u exp(prior / 2)) / (k r + u exp(-prior / 2))),   w = n / (n + 20),
/// with t and r the densities of the target's colors and of the rest (ColorDensity, relative to
/// colors spread evenly), u kUnseenDensity, k restPerTarget, and n the pixels of the side that has
/// fewer of them (of the only side if the other has none). So few pixels leave the prior, colors
/// that were never seen have the prior, and colors k times as dense in the target as in the rest
/// have about 0.
class TargetColorModel {
public:
  // Judgments, not measured.

  /// The prior log ratio of a color in the range, nats; outside it is the negative of it.
  static constexpr double kPrior = 1.0;
  /// Pixels of evidence that count as much as the prior.
  static constexpr double kPriorPixels = 20.0;
  /// The density below which a color counts as never seen, relative to colors spread evenly over
  /// all cells.
  static constexpr double kUnseenDensity = 0.3;
  /// How far the limits lie beyond the range: twice and more what other light does to a hue
  /// (inOtherLight()), and about as much for the others, as a fitted range ends where the
  /// background begins.
  static constexpr double kHueMarginDegrees = 20.0;
  static constexpr double kSaturationMargin = 0.15;
  static constexpr double kIntensityMargin = 0.10;

  /// The range widened by the margins.
  static ColorRange limitsOf(const ColorRange& range);

  /// Ranges have passed checkColorRange().
  explicit TargetColorModel(const ColorRange& range);
  TargetColorModel(const ColorRange& range, const ColorRange& limits);

  /// Colors of the target as a camera of this gain shows them; weights are pixels.
  void add(const std::vector<HsiColors>& colors, const ColorGain& gain = {});

  /// The table of a camera with this gain that shows the target before `rest` (its own images, its
  /// own colors; weights are pixels). `restPerTarget` > 0: how many pixels of the rest compete with
  /// one of the target. 1 makes it a ratio of likelihoods, for those who know otherwise how likely
  /// a target is at a place; pixelRatio() makes 0 the log ratio of colors with as many pixels of
  /// the target as of the rest, as fitRange() weighs them, for those who divide whole images.
  ColorLikelihood inCamera(const ColorGain& gain, const std::vector<HsiColors>& rest,
                           double restPerTarget = 1.0) const;

private:
  ColorRange range_;
  ColorRange limits_;
  std::vector<BgrColors> target_; ///< as the reference camera shows them
};

/// Pixels of the rest for each of the target; 1 where there are none of one of them.
double pixelRatio(const ColorEvidence& evidence);

/// The table of one camera, or of several that show colors alike, from samples and images.
ColorLikelihood learnLikelihood(const ColorEvidence& evidence, const ColorRange& range,
                                double restPerTarget = 1.0);

} // namespace dewpoint::color
