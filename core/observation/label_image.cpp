// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/label_image.h"

#include <algorithm>
#include <cmath>

namespace dewpoint {
namespace {

constexpr int kBlock = 32; ///< columns

} // namespace

void LabelImage::begin(const cv::Mat& image, const BackgroundModel& background,
                       const ColorClassifier& classifier) {
  image_ = image;
  background_ = &background;
  classifier_ = &classifier;
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

void LabelImage::require(const cv::Rect& area) {
  const cv::Rect whole(0, 0, image_.cols, image_.rows);
  cv::Rect wanted = area & whole;
  if (wanted.empty() || (wanted & covered_) == wanted) {
    return;
  }
  wanted |= covered_;
  // Whole blocks of columns: what is left over after them is classified one by one.
  const int left = wanted.x / kBlock * kBlock;
  const int right = (wanted.x + wanted.width + kBlock - 1) / kBlock * kBlock;
  covered_ = cv::Rect(left, wanted.y, right - left, wanted.height) & whole;
  make(covered_);
  for (const Explanation& explanation : explained_) {
    mark(explanation.other, explanation.except);
  }
}

void LabelImage::make(const cv::Rect& area) {
  matched_.resize(static_cast<std::size_t>(area.width));
  for (int row = area.y; row < area.y + area.height; ++row) {
    classifier_->matchRow(image_.ptr<std::uint8_t>(row) + std::ptrdiff_t{3} * area.x, area.width,
                          matched_.data());
    background_->labelRow(image_, area.x, row, area.width, matched_.data(),
                          labels_.ptr<std::uint8_t>(row) + area.x);
  }
}

void LabelImage::explain(const Circle& other, const Circle& except) {
  explained_.push_back({other, except});
  mark(other, except);
}

void LabelImage::mark(const Circle& other, const Circle& except) {
  const double reach = other.radius;
  const int top = std::max(covered_.y, static_cast<int>(std::ceil(other.center.y() - reach)));
  const int bottom = std::min(covered_.y + covered_.height - 1,
                              static_cast<int>(std::floor(other.center.y() + reach)));
  for (int row = top; row <= bottom; ++row) {
    const double above = row - other.center.y();
    const double half = std::sqrt(std::max(0.0, reach * reach - above * above));
    const int left = std::max(covered_.x, static_cast<int>(std::ceil(other.center.x() - half)));
    const int right = std::min(covered_.x + covered_.width - 1,
                               static_cast<int>(std::floor(other.center.x() + half)));
    std::uint8_t* labels = labels_.ptr<std::uint8_t>(row);
    for (int column = left; column <= right; ++column) {
      const bool kept = (Eigen::Vector2d(column, row) - except.center).squaredNorm() <
                        except.radius * except.radius;
      if (!kept && labels[column] == static_cast<std::uint8_t>(PixelLabel::Target)) {
        labels[column] = static_cast<std::uint8_t>(PixelLabel::Explained);
      }
    }
  }
}

} // namespace dewpoint
