// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/sphere_image.h"
#include "core/observation/background/label_image.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::observation {

/// The evidence of one image for a sphere of known size at a position, as a log likelihood ratio
/// against "no such sphere there": samples on twelve spokes, inside the expected outline and in a
/// ring around it. A smaller object of the same color does not fill the inside, a larger one fills
/// the ring as well. Pixels in which something may hide the target are no evidence
/// (PixelLabel::Unknown).
class SphereEvidence {
public:
  /// Samples reach this many radii from the center.
  static constexpr double kReach = 1.3;
  /// Factor of an outline's radius within which its blurred rim lies. A judgment
  /// (docs/method-dewpoint.md, section 2).
  static constexpr double kOutlineMargin = 1.05;
  /// The ratio of a fully visible target in front of nothing of its color.
  static double best();

  /// Log likelihood ratio of an outline in the labels, whose part around it must be covered. Less
  /// for outlines of few pixels, where the samples repeat each other.
  static double logLikelihoodRatio(const LabelImage& labels, const SphereImage& outline);
  /// The increase of the ratio when samples in the ring that other outlines cover are not counted
  /// against this one.
  static double explainedRingGain(const LabelImage& labels, const SphereImage& outline,
                                  const std::vector<SphereImage>& others);
  /// Share of the spokes on which the color ends at the outline, of those that nothing hides, 0 to
  /// 1: it matches inside, and the ring is neither of the color nor explained. 0 if more than two
  /// thirds are hidden.
  static double rimShare(const LabelImage& labels, const SphereImage& outline);
  /// Share of the samples inside the outline that match, 0 to 1.
  static double matchShare(const LabelImage& labels, const SphereImage& outline);
};

/// Whether the center of an outline is in an image of this size.
inline bool isInImage(const SphereImage& outline, const cv::Size& size) {
  return outline.center.x() >= 0.0 && outline.center.y() >= 0.0 &&
         outline.center.x() <= size.width - 1 && outline.center.y() <= size.height - 1;
}

/// The part of an image within `radii` radii of an outline's center, `margin` pixels wider.
cv::Rect areaOf(const SphereImage& outline, double radii, double margin = 2.0);

} // namespace dewpoint::observation
