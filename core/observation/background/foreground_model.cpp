// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/background/foreground_model.h"

#include "core/observation/background/running_background.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/video/background_segm.hpp>

#include <algorithm>

namespace dewpoint::observation {
namespace {

/// One of OpenCV's. It cannot spare a part of the image while it learns, so `keep` is answered by
/// learning that slowly.
class OpenCvForeground final : public ForegroundModel {
public:
  explicit OpenCvForeground(const ForegroundSettings& settings)
      : settings_(settings), subtractor_(make(settings)) {}

  void learn(const cv::Mat& image) override {
    // The first images count equally, as OpenCV's automatic rate has it.
    subtractor_->apply(image, mask_, 1.0 / static_cast<double>(++learned_));
  }

  void subtract(const cv::Mat& image, const cv::Mat& /*keep*/, cv::Mat& mask) override {
    subtractor_->apply(image, mask, 0.7 / std::max(1.0, settings_.memoryFrameCount));
    cv::threshold(mask, mask, kShadow, 255.0, cv::THRESH_BINARY);
  }

  std::unique_ptr<ForegroundModel> makeUntrained() const override {
    return std::make_unique<OpenCvForeground>(settings_);
  }

private:
  static constexpr double kShadow = 127.0; ///< OpenCV's value for one

  static cv::Ptr<cv::BackgroundSubtractor> make(const ForegroundSettings& settings) {
    if (settings.method == BackgroundMethod::Knn) {
      auto knn = cv::createBackgroundSubtractorKNN();
      knn->setShadowThreshold(settings.darkestShadow);
      return knn;
    }
    auto mog2 = cv::createBackgroundSubtractorMOG2();
    mog2->setShadowThreshold(settings.darkestShadow);
    return mog2;
  }

  ForegroundSettings settings_;
  cv::Ptr<cv::BackgroundSubtractor> subtractor_;
  cv::Mat mask_;
  int learned_ = 0;
};

} // namespace

std::unique_ptr<ForegroundModel> makeForegroundModel(const ForegroundSettings& settings) {
  if (settings.method == BackgroundMethod::Running) {
    return std::make_unique<RunningBackground>(settings);
  }
  return std::make_unique<OpenCvForeground>(settings);
}

} // namespace dewpoint::observation
