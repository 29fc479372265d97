// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/sphere_image.h"
#include "core/observation/background/label_image.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace dewpoint::observation {

/// Evidence from one image for a sphere of known size at a position: the log likelihood ratio of
/// "the sphere is here" against "no such sphere is here". The color is sampled on twelve spokes
/// (rays from the center), inside the expected outline and in a ring around it. A smaller object of
/// the same color does not fill the inside, and a larger object also fills the ring. Pixels at
/// which an object may hide the target (PixelLabel::Unknown) are not used as evidence.
class SphereEvidence {
public:
  /// Distance of the outermost color samples from the center of the outline, in radii of the
  /// outline.
  static constexpr double kSampleReach = 1.3;
  /// Factor by which the radius of an outline is enlarged to include the blurred rim. Chosen by
  /// judgment (docs/method-dewpoint.md, section 2).
  static constexpr double kOutlineMargin = 1.05;
  /// Returns the log likelihood ratio of a fully visible target whose color does not occur in the
  /// background.
  static double maxLogLikelihoodRatio();

  /// Returns the log likelihood ratio (natural logarithm) for a sphere with this outline in the
  /// image. The labels around the outline must have been computed. The ratio is lower for outlines
  /// of few pixels, where several samples fall on the same pixel.
  static double logLikelihoodRatio(const LabelImage& labels, const SphereImage& outline);
  /// Returns the amount by which logLikelihoodRatio() of an outline would increase if the samples
  /// in the ring around it that lie inside the outlines `others` did not count against the target.
  static double explainedRingGain(const LabelImage& labels, const SphereImage& outline,
                                  const std::vector<SphereImage>& others);
  /// Returns the fraction of the visible spokes, 0 to 1, on which the target color ends at the
  /// outline. On such a spoke, the sample inside the outline matches, and the sample in the ring
  /// neither matches nor is labeled Explained. Returns 0 if more than two thirds of the spokes are
  /// hidden.
  static double rimShare(const LabelImage& labels, const SphereImage& outline);
  /// Returns the fraction of the color samples inside the outline that match the target color, 0 to
  /// 1.
  static double matchShare(const LabelImage& labels, const SphereImage& outline);
};

/// Returns whether the center of an outline is inside an image of this size (pixels).
inline bool isInImage(const SphereImage& outline, const cv::Size& size) {
  return outline.center.x() >= 0.0 && outline.center.y() >= 0.0 &&
         outline.center.x() <= size.width - 1 && outline.center.y() <= size.height - 1;
}

/// Returns the bounding box of the circle around an outline's center with `radii` times the
/// outline's radius, plus a margin of `margin` pixels.
cv::Rect areaOf(const SphereImage& outline, double radii, double margin = 2.0);

} // namespace dewpoint::observation
