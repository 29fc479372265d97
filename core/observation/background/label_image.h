// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"
#include "core/observation/background/background_model.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <vector>

namespace dewpoint::observation {

/// What a pixel shows, as evidence for or against a target. "Matches" means that the pixel has the
/// target's color. An `Unknown` pixel neither matches nor agrees with the background, so something
/// may hide the target there. Such a pixel is evidence neither for nor against the target. Pixels
/// outside the image and pixels that another target explains are no evidence either.
enum class PixelLabel : std::uint8_t {
  Unlearned,  ///< does not match; the background is not known yet
  Background, ///< does not match and agrees with the background
  Unknown,    ///< does not match and shows something new
  Explained,  ///< matches, but belongs to another target or to the background image
  Target,     ///< matches the target's color
};
inline constexpr std::size_t kPixelLabelCount = 5;

/// Image of one camera with a label (PixelLabel: target, background, ...) for each pixel. Labels
/// are computed only where they are required.
class LabelImage {
public:
  /// Starts with a new image (CV_8UC3), without any labels. The image, background and classifiers
  /// must stay valid until the next call of setImage() or clear(). `classifier` tests for the
  /// target's color in the light of the image, `usual` in the reference light
  /// (BackgroundModel::relativeLight()).
  void setImage(const cv::Mat& image, const BackgroundModel& background,
                const ColorClassifier& classifier, const ColorClassifier& usual);
  void setImage(const cv::Mat& image, const BackgroundModel& background,
                const ColorClassifier& classifier) {
    setImage(image, background, classifier, classifier);
  }
  /// Removes the image and its labels. Call it for a frame in which the camera has no image.
  void clear();

  bool empty() const { return image_.empty(); }
  cv::Size size() const { return image_.size(); }

  /// Computes the labels of the pixels in an area, clipped to the image. Existing labels are not
  /// computed again.
  void ensureLabels(const cv::Rect& area);
  void ensureAllLabels() { ensureLabels({0, 0, image_.cols, image_.rows}); }
  /// Returns the part of the image whose labels have been computed, pixels.
  const cv::Rect& labeledArea() const { return covered_; }

  /// Circle in the image, pixels.
  struct Circle {
    Eigen::Vector2d center = Eigen::Vector2d::Zero();
    double radius = 0.0;
  };
  /// Labels matching pixels within `explainedCircle` as Explained, because another target is
  /// there. Pixels within `keptCircle` keep their labels. The circles also apply to labels
  /// that are computed later.
  void markExplained(const Circle& explainedCircle, const Circle& keptCircle);

  /// Returns the label of a pixel. Returns Explained, which is no evidence, for a pixel outside
  /// labeledArea().
  PixelLabel at(int column, int row) const noexcept {
    if (column < covered_.x || row < covered_.y || column >= covered_.x + covered_.width ||
        row >= covered_.y + covered_.height) {
      return PixelLabel::Explained;
    }
    return static_cast<PixelLabel>(labels_.ptr<std::uint8_t>(row)[column]);
  }
  /// Returns all labels as PixelLabel values: CV_8UC1 with the size of the image. The labels are
  /// valid only inside labeledArea().
  const cv::Mat& labels() const { return labels_; }

private:
  struct Explanation {
    Circle explainedCircle;
    Circle keptCircle;
  };
  void computeLabels(const cv::Rect& area);
  void applyExplanation(const Explanation& explanation, const cv::Rect& area);

  cv::Mat image_;
  const BackgroundModel* background_ = nullptr;
  const ColorClassifier* classifier_ = nullptr;
  const ColorClassifier* usual_ = nullptr;
  cv::Rect covered_;
  cv::Mat labels_;
  std::vector<Explanation> explained_;
  /// Marks the pixels in `row` that match only after conversion to the reference light, among those
  /// where matched_ is 0.
  void matchInReferenceLight(const std::uint8_t* row, int count);

  std::vector<std::uint8_t> matched_; ///< working memory, one row
  /// Working memory: colors of one row after conversion to the reference light.
  std::vector<std::uint8_t> relit_;
  std::vector<std::uint8_t> again_; ///< working memory, one row
};

} // namespace dewpoint::observation
