// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera_motion/background_patch.h"

#include "core/geometry/small_matrices.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace dewpoint::camera_motion {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
constexpr int kSidePx = BackgroundPatch::kSidePx;
constexpr int kHalf = kSidePx / 2;
constexpr int kCount = kSidePx * kSidePx;
constexpr int kWide = kSidePx + 2;         // with a rim, for gradients and interpolation
constexpr double kLeastStructure = 2500.0; // located to 0.1 px in the worst direction
constexpr double kNoise = 4.2;             // gray levels, of the difference of two images
/// Gauss-Newton steps.
constexpr int kMostSteps = 12;
constexpr double kEnough = 0.01;  // pixels
constexpr double kFarthest = 6.0; // pixels from the guess

/// In rows of `width`.
constexpr std::size_t indexOf(int row, int column, int width) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
         static_cast<std::size_t>(column);
}

using WideGray = std::array<float, std::size_t(kWide) * kWide>;

/// Gray levels of the patch and its rim, the corner of the rim at (left, top).
bool grayAround(const cv::Mat& image, int left, int top, WideGray& gray) {
  if (left < 0 || top < 0 || left + kWide > image.cols || top + kWide > image.rows) {
    return false;
  }
  for (int row = 0; row < kWide; ++row) {
    const cv::Vec3b* pixels = image.ptr<cv::Vec3b>(top + row) + left;
    for (int column = 0; column < kWide; ++column) {
      const cv::Vec3b& pixel = pixels[column];
      gray[indexOf(row, column, kWide)] =
          0.114F * float(pixel[0]) + 0.587F * float(pixel[1]) + 0.299F * float(pixel[2]);
    }
  }
  return true;
}

/// Mean 0, sum of squares 1; the former root of the sum of squares (0: left as it is).
float normalize(std::vector<float>& values) {
  float sum = 0.0F;
  for (const float value : values) {
    sum += value;
  }
  const float mean = sum / float(values.size());
  float squares = 0.0F;
  for (float& value : values) {
    value -= mean;
    squares += value * value;
  }
  const float length = std::sqrt(squares);
  if (length > 0.0F) {
    for (float& value : values) {
      value /= length;
    }
  }
  return length;
}

/// The patch at a place between pixels, bilinear.
bool sample(const cv::Mat& image, const Eigen::Vector2d& center, std::vector<float>& values) {
  const double left = center.x() - kHalf;
  const double top = center.y() - kHalf;
  WideGray gray;
  if (!grayAround(image, int(std::floor(left)), int(std::floor(top)), gray)) {
    return false;
  }
  const auto right = float(left - std::floor(left));
  const auto down = float(top - std::floor(top));
  const float weights[] = {(1 - right) * (1 - down), right * (1 - down), (1 - right) * down,
                           right * down};
  values.resize(kCount);
  for (int row = 0; row < kSidePx; ++row) {
    const float* upper = &gray[indexOf(row, 0, kWide)];
    const float* lower = upper + kWide;
    for (int column = 0; column < kSidePx; ++column) {
      values[indexOf(row, column, kSidePx)] =
          weights[0] * upper[column] + weights[1] * upper[column + 1] + weights[2] * lower[column] +
          weights[3] * lower[column + 1];
    }
  }
  return true;
}

} // namespace

std::optional<BackgroundPatch> BackgroundPatch::at(const cv::Mat& image, const cv::Point& center) {
  WideGray gray;
  if (!grayAround(image, center.x - kHalf - 1, center.y - kHalf - 1, gray)) {
    return std::nullopt;
  }
  BackgroundPatch patch;
  patch.center_ = center;
  patch.values_.resize(kCount);
  patch.gradientX_.resize(kCount);
  patch.gradientY_.resize(kCount);
  for (int row = 0; row < kSidePx; ++row) {
    for (int column = 0; column < kSidePx; ++column) {
      const auto i = indexOf(row, column, kSidePx);
      const auto wide = indexOf(row + 1, column + 1, kWide);
      patch.values_[i] = gray[wide];
      patch.gradientX_[i] = 0.5F * (gray[wide + 1] - gray[wide - 1]);
      patch.gradientY_[i] = 0.5F * (gray[wide + kWide] - gray[wide - kWide]);
    }
  }
  Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < kCount; ++i) {
    const Eigen::Vector2d gradient(patch.gradientX_[i], patch.gradientY_[i]);
    hessian += gradient * gradient.transpose();
  }
  patch.minEigenvalue_ = geometry::symmetricEigen2(hessian).values[0];
  if (!(patch.minEigenvalue_ > kLeastStructure)) {
    return std::nullopt;
  }
  patch.shiftCovariance_ = kNoise * kNoise * hessian.inverse();
  const float length = normalize(patch.values_);
  for (std::size_t i = 0; i < kCount; ++i) {
    patch.gradientX_[i] /= length;
    patch.gradientY_[i] /= length;
  }
  patch.inverseHessian_ = (hessian / double(length * length)).inverse();
  return patch;
}

std::optional<BackgroundPatch::Match> BackgroundPatch::find(const cv::Mat& image,
                                                            const Eigen::Vector2d& guess) const {
  const Eigen::Vector2d origin(center_.x, center_.y);
  Match match;
  match.shift = guess;
  std::vector<float> seen;
  for (int step = 0; step < kMostSteps; ++step) {
    if (!sample(image, origin + match.shift, seen) || normalize(seen) <= 0.0F) {
      return std::nullopt;
    }
    float correlation = 0.0F;
    float byX = 0.0F;
    float byY = 0.0F;
    for (std::size_t i = 0; i < kCount; ++i) {
      const float error = seen[i] - values_[i];
      correlation += seen[i] * values_[i];
      byX += gradientX_[i] * error;
      byY += gradientY_[i] * error;
    }
    match.correlation = correlation;
    const Eigen::Vector2d change = inverseHessian_ * Eigen::Vector2d(byX, byY);
    if (!(change.norm() < kFarthest)) {
      return std::nullopt;
    }
    match.shift -= change;
    if (change.norm() < kEnough) {
      break;
    }
  }
  if ((match.shift - guess).norm() > kFarthest) {
    return std::nullopt;
  }
  return match;
}

} // namespace dewpoint::camera_motion
