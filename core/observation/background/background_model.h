// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/background_suppression.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <vector>

namespace dewpoint::observation {

/// Background of one camera: a running mean color per pixel, learned during the recording. The
/// model distinguishes pixels that show the background from pixels that show something new. A new
/// object that stays becomes background after a while, so the model recovers after the camera is
/// moved or a lamp is switched on or off.
class BackgroundModel {
public:
  /// Circle in an image, in pixels. Nothing is learned inside the circle, because it may show a
  /// target.
  struct ExcludedCircle {
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    double radius = 0.0;
  };

  /// Number of agreeing observations after which the background color of a pixel is known. Three
  /// observations take 12 frames, because each frame updates every fourth row. With fewer
  /// observations, a passing object would be mistaken for background. Chosen by judgment.
  static constexpr int kObservationsUntilKnown = 3;
  /// Tolerance in gray levels: five standard deviations of usual sensor noise. A color agrees with
  /// the mean if the difference in each channel is at most this tolerance plus one eighth of the
  /// mean (mean >> kToleranceShiftBits). The eighth allows for small light changes.
  static constexpr int kBaseTolerance = kBackgroundTolerance;
  static constexpr int kToleranceShiftBits = kBackgroundToleranceShift;

  BackgroundModel() = default;
  /// Copies the model including its pixels.
  BackgroundModel(const BackgroundModel& other);
  BackgroundModel(BackgroundModel&&) = default;
  BackgroundModel& operator=(BackgroundModel other) noexcept;
  ~BackgroundModel() = default;

  /// Sets the background image, which shows the scene without targets (CV_8UC3; empty if there is
  /// none). The model learns the image at the next reset(). If a pixel of this image matches a
  /// target's color, later matches at that pixel are attributed to the background
  /// (PixelLabel::Explained), until a new object stays there.
  void setBackgroundImage(const cv::Mat& image) { backgroundImage_ = image.clone(); }
  /// Discards everything except the background image.
  void reset();
  /// Adapts the means to the light in an image if the whole image has suddenly become brighter,
  /// darker or differently tinted (estimateLightChange()). Call it before the labels of the image
  /// are computed.
  void adaptToLight(const cv::Mat& image);
  /// Learns from every fourth row of an image (CV_8UC3), starting at a different row each time. An
  /// image of another size restarts the model. Nothing is learned inside the circles `hidden`. Set
  /// `noTargetElsewhere` if there certainly is no target outside these circles. A pixel outside the
  /// circles that has a target's color then counts as background. After several such observations,
  /// the pixel is treated as if the background image contained its color.
  void learn(const cv::Mat& image, const std::vector<ExcludedCircle>& hidden,
             bool noTargetElsewhere = false);
  /// Discards what learn() with `noTargetElsewhere` has learned about target colors in the
  /// background. Call this function if the learned pixels may have shown a target after all. The
  /// version with a circle discards only what was learned inside the circle.
  void forgetFamiliarPixels();
  void forgetFamiliarPixels(const ExcludedCircle& circle);
  /// Returns the size of the model's images, bytes.
  std::size_t memoryBytes() const;
  /// Returns the fraction of known pixels, 0 to 1, that disagreed with the background in the last
  /// call of learn(). The fraction is near 1 if the camera is covered, receives no light, or was
  /// moved.
  double novelPixelShare() const { return novelShare_; }

  /// Returns the light of the last image relative to the reference light, per channel (blue, green,
  /// red). The reference light is the light of the first image, or the light at the last call of
  /// resetReferenceLight().
  const Eigen::Array3d& relativeLight() const { return light_; }
  void resetReferenceLight() { light_.setOnes(); }

  /// Value of `matched` in labelRow() for a pixel that has the target color only after conversion
  /// to the reference light. Such a pixel belongs to the target unless it agrees with the
  /// background.
  static constexpr std::uint8_t kMatchesInReferenceLight = 1;
  /// Computes the labels (PixelLabel) of `count` pixels in one row, from `column` on, and writes
  /// them to `labels`. `matched` says for each pixel whether it has the target color. If `matched`
  /// is 255, the label is Target, or Explained if the background image is known to show the same
  /// color there. If `matched` is 0, the label is Unlearned, Background or Unknown. If `matched` is
  /// kMatchesInReferenceLight (target color only after conversion to the reference light), the
  /// label is as for 255, except that a pixel that agrees with the background stays Background.
  void labelRow(const cv::Mat& image, int column, int row, int count, const std::uint8_t* matched,
                std::uint8_t* labels) const;

private:
  void learnRow(const cv::Mat& image, int row, const std::vector<ExcludedCircle>& hidden,
                bool noTargetElsewhere);
  void start(const cv::Mat& image);
  void learnPixels(const cv::Mat& image, int row, int begin, int end, bool noTargetElsewhere);

  cv::Mat mean_; ///< CV_8UC3
  /// CV_8UC1, number of observations of each pixel that agreed with the mean, up to kMostConfident.
  cv::Mat confidence_;
  /// CV_8UC1, for each pixel, how many successive observations up to the latest did not agree with
  /// the mean.
  cv::Mat novel_;
  cv::Mat backgroundImage_; ///< CV_8UC3, never modified
  /// CV_8UC1, or empty. 255 where the mean still comes from the background image. Elsewhere, the
  /// number of observations without a target; from kEmptyAfter on, they count as much as the
  /// background image.
  cv::Mat familiar_;
  /// True after the background image was learned, until the next image; the light of that image is
  /// not known yet.
  bool lightIsNew_ = false;
  int phase_ = 0;                   ///< first row of the next learn()
  std::int64_t known_ = 0;          ///< number of pixels in the last learn() that were known
  std::int64_t new_ = 0;            ///< number of these pixels that showed something new
  std::vector<std::uint8_t> moves_; ///< scratch, one row
  std::vector<std::uint8_t> news_;  ///< scratch, one row
  double novelShare_ = 0.0;
  Eigen::Array3d light_ = Eigen::Array3d::Ones();
};

} // namespace dewpoint::observation
