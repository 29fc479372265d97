// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"
#include "core/color/hsi_counts.h"
#include "core/color/likelihood/color_cells.h"
#include "core/color/likelihood/color_likelihood.h"

#include <vector>

namespace dewpoint::color {

struct ColorEvidence;

/// Color response of a camera relative to the reference camera: factors of its gray levels, each >
/// 0, from exposure (equal for all channels) and white balance. If gray levels are a power of the
/// light, a gain of the light is a gain of the gray levels too.
struct ColorGain {
  double blue = 1.0;
  double green = 1.0;
  double red = 1.0;

  bool operator==(const ColorGain&) const = default;
};

/// Color model of a target, common to all cameras and expressed as the reference camera shows
/// colors: the observed colors, and the HSI range that the user sees and edits. The range is the
/// prior, which decides about colors that were never seen. The range widened by margins is the
/// limit, beyond which no color counts as the target.
///
/// The table of a camera, per color cell, is
///   (1 - w) prior + w ln((t + u exp(prior / 2)) / (k r + u exp(-prior / 2))),   w = n / (n + 20),
/// with t and r the densities of the target's colors and of the rest (ColorDensity, relative to
/// colors spread evenly), u kUnseenDensity, k restPerTarget, and n the number of pixels of the side
/// that has fewer of them (of the only side if the other has none). With few pixels the result is
/// close to the prior; colors that were never seen have the prior; and colors that are k times as
/// dense in the target as in the rest have about 0.
class TargetColorModel {
public:
  // The constants below are judgments, not measured.

  /// Prior log ratio of a color in the range, in nats; colors outside have the negative of it.
  static constexpr double kPrior = 1.0;
  /// Number of pixels of evidence that count as much as the prior.
  static constexpr double kPriorPixels = 20.0;
  /// Density below which a color counts as never seen, relative to colors spread evenly over all
  /// cells.
  static constexpr double kUnseenDensity = 0.3;
  /// Margins of the limits beyond the range. The hue margin is at least twice the effect of other
  /// light on a hue (inOtherLight()), the other margins are about equal to it, because a fitted
  /// range ends where the background begins.
  static constexpr double kHueMarginDegrees = 20.0;
  static constexpr double kSaturationMargin = 0.15;
  static constexpr double kIntensityMargin = 0.10;

  /// Returns the range widened by the margins.
  static ColorRange limitsOf(const ColorRange& range);

  /// All ranges must have passed checkColorRange().
  explicit TargetColorModel(const ColorRange& range);
  TargetColorModel(const ColorRange& range, const ColorRange& limits);

  /// Adds colors of the target as a camera of this gain shows them; weights are in pixels.
  void add(const std::vector<HsiColors>& colors, const ColorGain& gain = {});

  /// Table of a camera with this gain that shows the target in front of `rest` (the colors of its
  /// own images; weights are in pixels). `restPerTarget` > 0 is the number of pixels of the rest
  /// that compete with one pixel of the target. With 1 the table is a likelihood ratio, for callers
  /// that know the probability of a target at a position from elsewhere. With pixelRatio() the log
  /// ratio is 0 for colors with as many pixels of the target as of the rest, as fitRange() weighs
  /// them, for callers that segment whole images.
  ColorLikelihood inCamera(const ColorGain& gain, const std::vector<HsiColors>& rest,
                           double restPerTarget = 1.0) const;

private:
  ColorRange range_;
  ColorRange limits_;
  std::vector<BgrColors> target_; ///< as the reference camera shows them
};

/// Number of pixels of the rest per pixel of the target; 1 if either has none.
double pixelRatio(const ColorEvidence& evidence);

/// Learns the table of one camera, or of several with the same color response, from samples and
/// images.
ColorLikelihood learnLikelihood(const ColorEvidence& evidence, const ColorRange& range,
                                double restPerTarget = 1.0);

} // namespace dewpoint::color
