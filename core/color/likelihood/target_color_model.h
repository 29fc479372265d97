// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_range.h"
#include "core/color/hsi_counts.h"
#include "core/color/likelihood/color_cells.h"
#include "core/color/likelihood/color_likelihood.h"

#include <vector>

namespace dewpoint::color {

struct ColorEvidence;

/// Color response of a camera relative to the reference camera: a factor > 0 for the gray levels of
/// each channel. The factors result from exposure (equal for all channels) and white balance. Gray
/// levels may also be proportional to a power of the light (gamma), because a constant factor of
/// the light is then still a constant factor of the gray levels.
struct ColorGain {
  double blue = 1.0;
  double green = 1.0;
  double red = 1.0;

  bool operator==(const ColorGain&) const = default;
};

/// Color model of a target, common to all cameras and expressed in the colors of the reference
/// camera. The model consists of the observed colors and the HSI range that the user sees and
/// edits. The range is the prior, which determines the values for colors that were never seen. The
/// range widened by margins is the limit: no color outside it counts as the target.
///
/// The table for a camera, per color cell, is
///   (1 - w) prior + w ln((t + u exp(prior / 2)) / (k r + u exp(-prior / 2))),   w = n / (n + 20).
/// Here t and r are the densities of the colors of the target and of the rest (ColorDensity,
/// relative to colors spread evenly), u is kUnseenColorDensity, and k is restPerTarget. n is the
/// number of pixels of the target or of the rest, whichever is smaller. If one of the two has no
/// pixels, n is the number of pixels of the other. With few pixels, the result is close to the
/// prior. For colors that were never seen, the result is the prior. The result is about 0 for
/// colors that are k times as dense in the target as in the rest.
class TargetColorModel {
public:
  // The constants below are judgments, not measurements.

  /// Prior log likelihood ratio, in nats, of a color inside the range that the user sees and edits.
  /// Colors outside have the negative of this value.
  static constexpr double kPriorLogRatio = 1.0;
  /// Number of observed pixels that count as much as the prior, which is the range that the user
  /// sees and edits.
  static constexpr double kPriorPixelCount = 20.0;
  /// Density u in the formula of this class, as a multiple of the density of evenly spread colors.
  /// A color counts as never seen, and its value is about the prior, where both its density t in
  /// the target and k times its density r in the rest are much smaller than u.
  static constexpr double kUnseenColorDensity = 0.3;
  /// Margins between the target's color range and the limits, outside which no color counts as the
  /// target. The hue margin is at least twice the effect of other light on a hue
  /// (withLightVariations()). The other margins are about equal to the effect of other light,
  /// because a fitted range ends where the background begins.
  static constexpr double kHueMarginDegrees = 20.0;
  static constexpr double kSaturationMargin = 0.15;
  static constexpr double kIntensityMargin = 0.10;

  /// Returns the range widened by the margins. No color outside the result counts as the target.
  static ColorRange limitsOf(const ColorRange& range);

  /// Creates a model without observed colors. All ranges must have passed checkColorRange().
  explicit TargetColorModel(const ColorRange& range);
  TargetColorModel(const ColorRange& range, const ColorRange& limits);

  /// Adds target colors as shown by a camera with this gain. Weights are in pixels.
  void add(const std::vector<WeightedHsiColor>& colors, const ColorGain& gain = {});

  /// Returns the table of log likelihood ratios for a camera with this gain that shows the target
  /// in front of `rest` (the colors in the camera's own images; weights are in pixels).
  /// `restPerTarget` > 0 is the number of pixels of the rest that compete with one target pixel. If
  /// it is 1, the table is a likelihood ratio, for callers that know the probability of a target at
  /// a position from another source. If it is restPixelsPerTargetPixel(), the log ratio is 0 for
  /// colors with as many pixels in the target as in the rest, consistent with the weights in
  /// fitRange(). Use restPixelsPerTargetPixel() to segment whole images.
  ColorLikelihood likelihoodForCamera(const ColorGain& gain,
                                      const std::vector<WeightedHsiColor>& rest,
                                      double restPerTarget = 1.0) const;

private:
  ColorRange range_;
  ColorRange limits_;
  std::vector<WeightedBgrColor> target_; ///< in the colors of the reference camera
};

/// Returns the number of pixels of the rest (everything except the target) per target pixel.
/// Returns 1 if the target or the rest has no pixels.
double restPixelsPerTargetPixel(const ColorEvidence& evidence);

/// Learns the table of log likelihood ratios for one camera, or for several with the same color
/// response, from evidence. `range` is the prior; for `restPerTarget`, see
/// TargetColorModel::likelihoodForCamera().
ColorLikelihood learnLikelihood(const ColorEvidence& evidence, const ColorRange& range,
                                double restPerTarget = 1.0);

} // namespace dewpoint::color
