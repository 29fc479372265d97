// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/background/label_image.h"

#include "core/base/vector_kernel.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dewpoint::observation {
namespace {

constexpr int kBlock = 32; ///< columns
/// Relative change of light, in any channel, up to which a color stays within its range. A judgment
/// (docs/method-dewpoint.md, section 2).
constexpr double kOtherLight = 0.1;
constexpr int kGainBits = 8; ///< of the fraction of a fixed-point gain

struct RelightKernel {
  /// relit = pixel x gain (blue, green, red; in 1/256), cut at 255.
  DEWPOINT_KERNEL void run(const std::uint8_t* pixel, std::int64_t count, std::int32_t blue,
                           std::int32_t green, std::int32_t red, std::uint8_t* relit) {
    const auto scaled = [](std::uint8_t value, std::int32_t gain) {
      const std::int32_t product = (value * gain + (1 << (kGainBits - 1))) >> kGainBits;
      return static_cast<std::uint8_t>(product < 255 ? product : 255);
    };
    for (std::int64_t i = 0; i < count; ++i) {
      relit[3 * i] = scaled(pixel[3 * i], blue);
      relit[3 * i + 1] = scaled(pixel[3 * i + 1], green);
      relit[3 * i + 2] = scaled(pixel[3 * i + 2], red);
    }
  }
};

struct EitherKernel {
  DEWPOINT_KERNEL void run(const std::uint8_t* again, std::int64_t count, std::uint8_t* matched) {
    for (std::int64_t i = 0; i < count; ++i) {
      matched[i] |= static_cast<std::uint8_t>(again[i] & BackgroundModel::kMatchesInReferenceLight);
    }
  }
};

} // namespace

void LabelImage::setImage(const cv::Mat& image, const BackgroundModel& background,
                          const ColorClassifier& classifier, const ColorClassifier& usual) {
  image_ = image;
  background_ = &background;
  classifier_ = &classifier;
  usual_ = &usual;
  covered_ = {};
  explained_.clear();
  if (labels_.size() != image.size()) {
    labels_.create(image.size(), CV_8UC1);
  }
}

void LabelImage::clear() {
  image_ = cv::Mat();
  covered_ = {};
  explained_.clear();
}

void LabelImage::ensureLabels(const cv::Rect& area) {
  const cv::Rect whole(0, 0, image_.cols, image_.rows);
  cv::Rect wanted = area & whole;
  if (wanted.empty() || (wanted & covered_) == wanted) {
    return;
  }
  wanted |= covered_;
  // Whole blocks of columns: what is left over after them is classified one by one.
  const int left = wanted.x / kBlock * kBlock;
  const int right = (wanted.x + wanted.width + kBlock - 1) / kBlock * kBlock;
  const cv::Rect before = covered_;
  covered_ = cv::Rect(left, wanted.y, right - left, wanted.height) & whole;
  if (before.empty()) {
    computeLabels(covered_);
    return;
  }
  const int bottom = before.y + before.height;
  const int behind = before.x + before.width;
  computeLabels({covered_.x, covered_.y, covered_.width, before.y - covered_.y});
  computeLabels({covered_.x, bottom, covered_.width, covered_.y + covered_.height - bottom});
  computeLabels({covered_.x, before.y, before.x - covered_.x, before.height});
  computeLabels({behind, before.y, covered_.x + covered_.width - behind, before.height});
}

void LabelImage::matchInReferenceLight(const std::uint8_t* row, int count) {
  const auto width = static_cast<std::size_t>(count);
  relit_.resize(3 * width);
  again_.resize(width);
  const auto gain = [&](Eigen::Index channel) {
    return static_cast<std::int32_t>(
        std::lround((1 << kGainBits) / background_->relativeLight()[channel]));
  };
  runKernel<RelightKernel>(row, std::int64_t{count}, gain(0), gain(1), gain(2), relit_.data());
  usual_->matchRow(relit_.data(), count, again_.data());
  runKernel<EitherKernel>(static_cast<const std::uint8_t*>(again_.data()), std::int64_t{count},
                          matched_.data());
}

void LabelImage::computeLabels(const cv::Rect& area) {
  if (area.empty()) {
    return;
  }
  matched_.resize(static_cast<std::size_t>(area.width));
  const bool otherLight = (background_->relativeLight() - 1.0).abs().maxCoeff() > kOtherLight;
  for (int row = area.y; row < area.y + area.height; ++row) {
    const std::uint8_t* pixels = image_.ptr<std::uint8_t>(row) + std::ptrdiff_t{3} * area.x;
    classifier_->matchRow(pixels, area.width, matched_.data());
    if (otherLight) {
      matchInReferenceLight(pixels, area.width);
    }
    background_->labelRow(image_, area.x, row, area.width, matched_.data(),
                          labels_.ptr<std::uint8_t>(row) + area.x);
  }
  for (const Explanation& explanation : explained_) {
    applyExplanation(explanation, area);
  }
}

void LabelImage::markExplained(const Circle& explainedCircle, const Circle& keptCircle) {
  explained_.push_back({explainedCircle, keptCircle});
  applyExplanation(explained_.back(), covered_);
}

void LabelImage::applyExplanation(const Explanation& explanation, const cv::Rect& area) {
  const auto& [explainedCircle, keptCircle] = explanation;
  const double reach = explainedCircle.radius;
  const int top = std::max(area.y, static_cast<int>(std::ceil(explainedCircle.center.y() - reach)));
  const int bottom = std::min(area.y + area.height - 1,
                              static_cast<int>(std::floor(explainedCircle.center.y() + reach)));
  for (int row = top; row <= bottom; ++row) {
    const double above = row - explainedCircle.center.y();
    const double half = std::sqrt(std::max(0.0, reach * reach - above * above));
    const int left =
        std::max(area.x, static_cast<int>(std::ceil(explainedCircle.center.x() - half)));
    const int right = std::min(area.x + area.width - 1,
                               static_cast<int>(std::floor(explainedCircle.center.x() + half)));
    std::uint8_t* labels = labels_.ptr<std::uint8_t>(row);
    for (int column = left; column <= right; ++column) {
      const bool kept = (Eigen::Vector2d(column, row) - keptCircle.center).squaredNorm() <
                        keptCircle.radius * keptCircle.radius;
      if (!kept && labels[column] == static_cast<std::uint8_t>(PixelLabel::Target)) {
        labels[column] = static_cast<std::uint8_t>(PixelLabel::Explained);
      }
    }
  }
}

} // namespace dewpoint::observation
