// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/sphere_image.h"
#include "core/observation/background/label_image.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::observation {

/// How strongly one image speaks for a sphere of known size at a place, as a log likelihood ratio
/// against "no such sphere there": pairs of samples on twelve spokes, inside the expected outline
/// and in a ring around it. A smaller or larger thing of the same color fills only the inside, or
/// the ring as well, and is told apart; pixels that may be hidden by something carry no evidence
/// (PixelLabel::Unknown).
class SphereEvidence {
public:
  /// Samples reach this many radii from the center.
  static constexpr double kReach = 1.3;
  /// The ratio of a fully visible target in front of nothing of its color.
  static double best();

  /// Log likelihood ratio of an outline in the labels, whose part around it must be covered. Less
  /// for outlines of few pixels, where the samples repeat each other.
  static double logLikelihoodRatio(const LabelImage& labels, const SphereImage& outline);
  /// By how much the ratio rises when what other outlines cover is taken to be theirs: a matching
  /// sample in the ring then says nothing against this one.
  static double explainedRingGain(const LabelImage& labels, const SphereImage& outline,
                                  const std::vector<SphereImage>& others);
  /// Share of the samples inside the outline that match, 0 to 1.
  static double matchShare(const LabelImage& labels, const SphereImage& outline);
};

/// The part of an image that the evidence of this outline looks at, `margin` pixels wider.
cv::Rect areaOf(const SphereImage& outline, double radii, double margin = 2.0);

} // namespace dewpoint::observation
