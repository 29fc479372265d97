// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/color_window.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dewpoint {
namespace {

constexpr int kWindowRadius = 2;
constexpr int kWindowPixels = 25;

/// log(max(m, 1) / 25) for m = 0..25.
const std::array<double, kWindowPixels + 1>& logTable() {
  static const auto table = [] {
    std::array<double, kWindowPixels + 1> values{};
    for (int m = 0; m <= kWindowPixels; ++m) {
      values[static_cast<std::size_t>(m)] =
          std::log(std::max(m, 1) / static_cast<double>(kWindowPixels));
    }
    return values;
  }();
  return table;
}

bool matchesAt(const ColorClassifier& classifier, const std::uint8_t* pixel) {
  return classifier.matches(pixel[0], pixel[1], pixel[2]);
}

} // namespace

ColorWindow::ColorWindow(const CameraRig& rig, const ColorClassifier& classifier)
    : classifier_(classifier) {
  views_.reserve(rig.size());
  for (const Camera& camera : rig) {
    views_.push_back(View{Projector(camera), {}, {}});
  }
}

void ColorWindow::setClassifier(const ColorClassifier& classifier) {
  classifier_ = classifier;
  for (View& view : views_) {
    view.integral.clear();
  }
}

void ColorWindow::setImage(std::size_t camera, const cv::Mat& image) {
  View& view = views_.at(camera);
  view.image = image.type() == CV_8UC3 ? image : cv::Mat();
  view.integral.clear();
}

void ColorWindow::prepare(std::int64_t particleCount) {
  for (View& view : views_) {
    const auto pixels = static_cast<std::int64_t>(view.image.total());
    if (particleCount * kWindowPixels < pixels) {
      view.integral.clear();
    } else if (view.integral.empty() && pixels > 0) {
      buildIntegral(view);
    }
  }
}

void ColorWindow::addLogLikelihood(ConstStateRows rows, LogWeightSegment logLikelihood) const {
  const auto& logs = logTable();
  for (const View& view : views_) {
    if (view.image.empty()) {
      continue;
    }
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      const auto count = matchCount(view, {rows(i, 0), rows(i, 1), rows(i, 2)});
      // Outside is 1/25, which is what no match at all is raised to.
      logLikelihood[i] += logs[static_cast<std::size_t>(count.value_or(0))];
    }
  }
}

std::optional<int> ColorWindow::matchCount(std::size_t camera,
                                           const Eigen::Vector3d& pointWorld) const {
  return matchCount(views_.at(camera), pointWorld);
}

std::optional<int> ColorWindow::matchCount(const View& view,
                                           const Eigen::Vector3d& pointWorld) const {
  const cv::Mat& image = view.image;
  const auto pixel = view.projector.project(pointWorld);
  if (image.empty() || !pixel) {
    return std::nullopt;
  }
  // Pixel centers lie at integers: pixel k covers [k - 0.5, k + 0.5).
  const double columnReal = std::floor(pixel->x() + 0.5);
  const double rowReal = std::floor(pixel->y() + 0.5);
  const bool inside = columnReal >= 0.0 && columnReal < image.cols && rowReal >= 0.0 &&
                      rowReal < image.rows; // false for NaN
  if (!inside) {
    return std::nullopt;
  }
  const int column = static_cast<int>(columnReal);
  const int row = static_cast<int>(rowReal);
  const int left = std::max(column - kWindowRadius, 0);
  const int top = std::max(row - kWindowRadius, 0);
  const int right = std::min(column + kWindowRadius + 1, image.cols);
  const int bottom = std::min(row + kWindowRadius + 1, image.rows);
  if (view.integral.empty()) {
    return countPixels(image, left, top, right, bottom);
  }
  const std::size_t stride = static_cast<std::size_t>(image.cols) + 1;
  const auto sum = [&](int x, int y) {
    return view.integral[static_cast<std::size_t>(y) * stride + static_cast<std::size_t>(x)];
  };
  return sum(right, bottom) - sum(left, bottom) - sum(right, top) + sum(left, top);
}

int ColorWindow::countPixels(const cv::Mat& image, int left, int top, int right, int bottom) const {
  int count = 0;
  for (int row = top; row < bottom; ++row) {
    const std::uint8_t* pixel = image.ptr<std::uint8_t>(row) + std::ptrdiff_t{3} * left;
    for (int column = left; column < right; ++column, pixel += 3) {
      count += matchesAt(classifier_, pixel) ? 1 : 0;
    }
  }
  return count;
}

void ColorWindow::buildIntegral(View& view) const {
  const std::size_t stride = static_cast<std::size_t>(view.image.cols) + 1;
  view.integral.assign(stride * (static_cast<std::size_t>(view.image.rows) + 1), 0);
  for (int row = 0; row < view.image.rows; ++row) {
    const std::uint8_t* pixel = view.image.ptr<std::uint8_t>(row);
    const std::int32_t* above = view.integral.data() + static_cast<std::size_t>(row) * stride;
    std::int32_t* below = view.integral.data() + (static_cast<std::size_t>(row) + 1) * stride;
    std::int32_t inRow = 0;
    for (int column = 0; column < view.image.cols; ++column, pixel += 3) {
      inRow += matchesAt(classifier_, pixel) ? 1 : 0;
      below[column + 1] = above[column + 1] + inRow;
    }
  }
}

} // namespace dewpoint
