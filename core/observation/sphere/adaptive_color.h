// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"
#include "core/color/color_ranges.h"
#include "core/geometry/sphere_image.h"
#include "core/observation/sphere/followed_range.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::observation {

/// A target's colors as each camera sees them while the light changes slowly. The bounds of the
/// learned ranges follow the quantiles of the colors on the target: by as much as hue
/// and saturation differ from those at first, and by the factor by which the intensity does. Where
/// the background comes to have the target's color in the light of now (noise in the dark has any
/// hue) a bound moves closer to its quantile, as long as that raises the F1 score of the pixels.
/// Only frames in which the target is certain and not covered may be learned from.
class AdaptiveColor {
public:
  /// At least one range; all have passed checkColorRange().
  AdaptiveColor(const ColorRanges& learned, std::size_t cameras);

  /// The color as it was learned. Labels keep the addresses of this and of inUse(): both stay where
  /// they are when the color is moved.
  const ColorClassifier& learned() const { return *learnedClassifier_; }
  /// The color in use in one camera.
  const ColorClassifier& inUse(std::size_t camera) const { return cameras_.at(camera).classifier; }
  ColorRanges rangesInUse(std::size_t camera) const;
  /// Of all cameras; empty while every one uses the ranges as they were learned.
  std::vector<ColorRanges> rangesInUse() const;

  /// Back to what was learned, in all cameras.
  void forget();
  /// Back to the first light of each camera: what follow() has changed is undone, reach() is not.
  void undoFollowing();
  /// Takes the ranges for what they mean in the light of a camera's image, see reachInLight(). For
  /// a target that is not tracked: what follow() has found out about this camera is lost.
  void reach(std::size_t camera, const cv::Mat& image);
  /// Updates the color in one camera by an image (CV_8UC3) that shows the target whole and alone:
  /// moves `share` (0 to 1) of the way to the colors there; a range of which too little is seen
  /// stays. The first kReferenceUpdates updates of a range only measure its colors in the first
  /// light. `others` are outlines of other objects of
  /// its color. Does nothing where too few pixels inside the outline have about the color in use,
  /// and takes no step that would let in more of the ring around the target, or of the rest of the
  /// image, than is allowed. Returns whether a step was taken.
  bool follow(std::size_t camera, const cv::Mat& image, const SphereImage& outline,
              const std::vector<SphereImage>& others, double share);

  /// A third of a second; a judgment (docs/method-dewpoint.md, section 8).
  static constexpr int kReferenceUpdates = 10;

private:
  struct PerCamera {
    std::vector<FollowedRange> ranges;
    ColorClassifier classifier;
    int updateCount = 0;
    double restShare = 0.0; ///< of the rest of the image that matched in the first light
  };
  struct TargetImage;
  using Quantiles = FollowedRange::Quantiles;
  /// Of each range; nothing where too few pixels have about its color.
  using Measured = std::vector<std::optional<Quantiles>>;

  static PerCamera startOf(const ColorRanges& base);
  static ColorRanges rangesOf(const PerCamera& camera);
  /// Whether enough pixels of the target have about one of its colors.
  static bool measure(const PerCamera& camera, const TargetImage& target, Measured& measured);
  /// The F1 score after the step; nothing when it was not taken.
  static std::optional<double> step(PerCamera& camera, const TargetImage& target,
                                    const Measured& next);
  static void tighten(PerCamera& camera, const TargetImage& target, double f1);

  ColorRanges learned_;
  std::shared_ptr<const ColorClassifier> learnedClassifier_; ///< never null; shared by copies
  std::vector<PerCamera> cameras_;
};

} // namespace dewpoint::observation
