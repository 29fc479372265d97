// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/background/foreground_model.h"

#include <array>
#include <cstdint>
#include <vector>

namespace dewpoint::observation {

/// Background model with one Gaussian per pixel (Wren et al. 1997, "Pfinder"): a mean per channel,
/// and one mean absolute difference for all three channels. Shadows are recognized by their color:
/// all channels are darker by about the same factor, as in Horprasert et al. 1999. The model is
/// deliberately simple and takes only a fraction of the computing time of a mixture model.
class RunningBackground final : public ForegroundModel, public CopyableForeground {
public:
  explicit RunningBackground(const ForegroundSettings& settings) : settings_(settings) {}

  void learn(const cv::Mat& image) override;
  void subtract(const cv::Mat& image, const cv::Mat& keep, cv::Mat& mask) override;
  std::unique_ptr<ForegroundModel> makeUntrained() const override {
    return std::make_unique<RunningBackground>(settings_);
  }
  std::unique_ptr<ForegroundModel> clone() const override {
    auto copy = std::make_unique<RunningBackground>(*this);
    copy->planes_ = {}; // rewritten with every image
    return copy;
  }
  std::size_t memoryBytes() const override {
    return (3 * means_.front().size() + deviation_.size()) * sizeof(float);
  }

private:
  void start(const cv::Mat& image);
  void splitChannels(const cv::Mat& image);

  ForegroundSettings settings_;
  cv::Size size_;
  int learned_ = 0;
  std::array<std::vector<float>, 3> means_; ///< per channel (BGR), gray levels
  std::vector<float> deviation_;      ///< mean absolute difference over all channels, gray levels
  std::array<cv::Mat, 3> planes_;     ///< channels of the current image, CV_8UC1, continuous
  std::vector<std::uint8_t> nothing_; ///< used instead of an empty `keep`
};

} // namespace dewpoint::observation
