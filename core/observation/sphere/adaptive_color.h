// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"
#include "core/geometry/sphere_image.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace dewpoint::observation {

/// A target's color as each camera sees it while the light changes slowly. The bounds of the
/// learned range follow the quantiles of the colors on the target: by as much as hue
/// and saturation differ from those at first, and by the factor by which the intensity does. Where
/// the background comes to have the target's color in the light of now (noise in the dark has any
/// hue) a bound moves closer to its quantile, as long as that raises the F1 score of the pixels.
/// Only frames in which the target is certain and not covered may be learned from.
class AdaptiveColor {
public:
  /// `learned` has passed checkColorRange().
  AdaptiveColor(const ColorRange& learned, std::size_t cameras);

  /// The range as it was learned. Labels keep the addresses of this and of inUse(): both stay where
  /// they are when the color is moved.
  const ColorClassifier& learned() const { return *learnedClassifier_; }
  const ColorRange& learnedRange() const { return learned_; }
  /// The range in use in one camera.
  const ColorClassifier& inUse(std::size_t camera) const { return cameras_.at(camera).classifier; }
  const ColorRange& rangeInUse(std::size_t camera) const { return cameras_.at(camera).range; }
  /// Of all cameras; empty while every one uses the range as it was learned.
  std::vector<ColorRange> rangesInUse() const;

  /// Back to what was learned, in all cameras.
  void forget();
  /// Back to the first light of each camera: what follow() has changed is undone, reach() is not.
  void undoFollowing();
  /// Takes the range for what it means in the light of a camera's image, see reachInLight(). For a
  /// target that is not tracked: what follow() has found out about this camera is lost.
  void reach(std::size_t camera, const cv::Mat& image);
  /// Updates the color in one camera by an image (CV_8UC3) that shows the target whole and alone:
  /// moves `share` (0 to 1) of the way to the colors there. The first kReferenceUpdates updates of
  /// a camera only measure the colors in the first light. `others` are outlines of other objects of
  /// its color. Does nothing where too few pixels inside the outline have about the color in use,
  /// and takes no step that would let in more of the ring around the target, or of the rest of the
  /// image, than is allowed. Returns whether a step was taken.
  bool follow(std::size_t camera, const cv::Mat& image, const SphereImage& outline,
              const std::vector<SphereImage>& others, double share);

  /// A third of a second; a judgment (docs/method-dewpoint.md, section 8).
  static constexpr int kReferenceUpdates = 10;

private:
  /// Low and high quantiles: of hue (degrees from the center of the learned range), saturation,
  /// and the logarithm of the intensity.
  static constexpr std::size_t kBounds = 6;
  using Quantiles = std::array<double, kBounds>;
  struct PerCamera {
    int updateCount = 0;
    Quantiles reference{}; ///< in the first light
    Quantiles now{};
    Quantiles slack{1, 1, 1, 1, 1, 1}; ///< from quantile to bound, as a share of that learned
    double restShare = 0.0;            ///< of the rest of the image that matched in the first light
    ColorRange base;                   ///< the learned range as it reaches in the first light
    ColorRange range;
    ColorClassifier classifier;
  };
  struct TargetImage;

  static Quantiles boundsOf(const ColorRange& range);
  static double hueCenter(const ColorRange& range);
  bool measure(const PerCamera& camera, const TargetImage& target, Quantiles& measured) const;
  ColorRange rangeOf(const PerCamera& camera, const Quantiles& now, const Quantiles& slack) const;
  void begin(PerCamera& camera, const TargetImage& target, const Quantiles& measured) const;
  /// The F1 score after the step; nothing when it was not taken.
  std::optional<double> step(PerCamera& camera, const TargetImage& target,
                             const Quantiles& next) const;
  void tighten(PerCamera& camera, const TargetImage& target, double f1) const;

  ColorRange learned_;
  std::shared_ptr<const ColorClassifier> learnedClassifier_; ///< never null; shared by copies
  std::vector<PerCamera> cameras_;
};

} // namespace dewpoint::observation
