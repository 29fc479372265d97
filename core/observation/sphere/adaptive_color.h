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
/// learned range follow the quantiles of the colors on the target: as much as hue and saturation
/// are another now than at first, and by the factor by which the intensity is. Where the room comes
/// to look like the target in the light of now (noise in the dark has any hue) a bound moves closer
/// to its quantile, as long as that raises the F1 score of the pixels. The caller sees to it
/// that only frames are learned from in which the target is there and not covered.
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
  /// One look at the target, whole and alone, in an image (CV_8UC3): goes `share` (0 to 1) of the
  /// way to the colors there. The first kReferenceLooks looks of a camera only say what the target
  /// looks like in the light of the beginning. `others` are outlines of things that have its color
  /// as well. Does nothing where too little within the outline has about the color in use, and
  /// takes no step that would let in more of the ring around the target, or of the rest of the
  /// image, than is allowed. Whether a step was taken.
  bool follow(std::size_t camera, const cv::Mat& image, const SphereImage& outline,
              const std::vector<SphereImage>& others, double share);

  static constexpr int kReferenceLooks = 10;

private:
  /// Low and high quantiles: of hue (degrees from the middle of the learned range), saturation,
  /// and the logarithm of the intensity.
  static constexpr std::size_t kBounds = 6;
  using Quantiles = std::array<double, kBounds>;
  struct PerCamera {
    int looks = 0;
    Quantiles reference{}; ///< in the light of the beginning
    Quantiles now{};
    Quantiles slack{1, 1, 1, 1, 1, 1}; ///< from quantile to bound, as a share of that learned
    double restShare = 0.0;            ///< of the rest of the image that matched at the beginning
    ColorRange range;
    ColorClassifier classifier;
  };
  struct Look;

  Quantiles learnedBounds() const;
  double hueMiddle() const;
  bool measure(const PerCamera& camera, const Look& look, Quantiles& measured) const;
  ColorRange rangeOf(const PerCamera& camera, const Quantiles& now, const Quantiles& slack) const;
  void begin(PerCamera& camera, const Look& look, const Quantiles& measured) const;
  /// The F1 score after the step; nothing when it was not taken.
  std::optional<double> step(PerCamera& camera, const Look& look, const Quantiles& next) const;
  void tighten(PerCamera& camera, const Look& look, double f1) const;

  ColorRange learned_;
  std::shared_ptr<const ColorClassifier> learnedClassifier_; ///< never null; shared by copies
  std::vector<PerCamera> cameras_;
};

} // namespace dewpoint::observation
