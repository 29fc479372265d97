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

/// Color ranges of a target, adapted in each camera to slow changes of the light. The bounds of the
/// ranges follow the quantiles of the colors on the target. Bounds of hue and saturation are
/// shifted by the difference between the current and the initial quantiles. Bounds of intensity are
/// multiplied by the ratio of these quantiles. In the current light, the background may also have
/// the target color, because noise in dark images has any hue, for example. A bound then moves
/// closer to its quantile, as long as this raises the F1 score (the harmonic mean of precision and
/// recall of the matching pixels). Learn only from frames in which the position of the target is
/// certain and nothing covers the target.
class AdaptiveColor {
public:
  /// Starts with the ranges `learned` in every camera. There must be at least one range, and all
  /// ranges must have passed checkColorRange().
  AdaptiveColor(const ColorRanges& learned, std::size_t cameras);

  /// Returns the classifier for the color as first learned. Label images keep pointers to this
  /// classifier and to classifierInUse(), so their addresses stay the same when the AdaptiveColor
  /// is moved.
  const ColorClassifier& learnedClassifier() const { return *learnedClassifier_; }
  /// Returns the classifier currently used in one camera.
  const ColorClassifier& classifierInUse(std::size_t camera) const {
    return cameras_.at(camera).classifier;
  }
  ColorRanges rangesInUse(std::size_t camera) const;
  /// Returns the ranges in use, one entry per camera. The list is empty while every camera uses the
  /// ranges as first learned.
  std::vector<ColorRanges> rangesInUse() const;

  /// Restores the learned ranges in all cameras.
  void restoreLearnedRanges();
  /// Restores the ranges for the initial light in each camera. Undoes all calls of adapt(), but no
  /// calls of extendToLight().
  void undoAdaptation();
  /// Adjusts the ranges of a camera to the light in its image (extendRangeToLight()). Use it for a
  /// target that is not tracked at present. If a range changes, all changes by adapt() in this
  /// camera are lost.
  void extendToLight(std::size_t camera, const cv::Mat& image);
  /// Updates the color in one camera from an image (CV_8UC3) in which the target is completely
  /// visible and not covered. The ranges move toward the colors on the target by the fraction
  /// `share` (0 to 1) of the difference. A range with too few visible pixels stays unchanged. The
  /// first kReferenceUpdateCount updates of a range do not change the range; they measure the
  /// colors in the initial light. `others` are outlines of other objects with the same color.
  ///
  /// Returns whether the ranges were moved. The ranges are not moved if too few pixels inside the
  /// outline have approximately the color in use, or if the new ranges would match too much of the
  /// ring around the target or of the rest of the image.
  bool adapt(std::size_t camera, const cv::Mat& image, const SphereImage& outline,
             const std::vector<SphereImage>& others, double share);

  /// Number of updates at the start that do not change a range, but measure the colors of the
  /// target in the initial light. Ten updates take a third of a second at 30 images per second.
  /// Chosen by judgment (docs/method-dewpoint.md, section 8).
  static constexpr int kReferenceUpdateCount = 10;

private:
  struct PerCamera {
    std::vector<FollowedRange> ranges;
    ColorClassifier classifier;
    int updateCount = 0;
    double initialMatchShareElsewhere =
        0.0; ///< fraction of the rest of the image that matched in the initial light
  };
  struct TargetImage;
  using Quantiles = FollowedRange::Quantiles;
  /// For each color range, the quantiles of the colors of the pixels near it. An entry is empty if
  /// too few pixels have a color near this range.
  using Measured = std::vector<std::optional<Quantiles>>;

  static PerCamera initialState(const ColorRanges& base);
  static ColorRanges rangesOf(const PerCamera& camera);
  /// Measures the quantiles of the colors of the target's pixels in one camera, and writes them to
  /// `measured`. Returns false if too few of these pixels have approximately one of the target's
  /// colors.
  static bool measure(const PerCamera& camera, const TargetImage& target, Measured& measured);
  /// Moves the ranges of a camera to the quantiles `next`. Returns the F1 score after this step, or
  /// nothing if the step was rejected.
  static std::optional<double> step(PerCamera& camera, const TargetImage& target,
                                    const Measured& next);
  static void tighten(PerCamera& camera, const TargetImage& target, double f1);

  ColorRanges learned_;
  std::shared_ptr<const ColorClassifier> learnedClassifier_; ///< never null; shared by copies
  std::vector<PerCamera> cameras_;
};

} // namespace dewpoint::observation
