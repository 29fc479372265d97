// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/observation/sphere/color_window.h"

#include "core/base/vector_kernel.h"
#include "core/geometry/projector.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dewpoint::observation {
namespace {

constexpr int kWindowBlock = kMaxWindows;
/// Counting a whole image takes as long as this many of its pixels have windows counted one by one:
/// measured (bench/color_window_bench).
constexpr std::int64_t kPixelsPerWindow = 60;

using LogTable = std::array<double, WindowCounts::kWindowPixelCount + 1>;

/// log(max(m, 1) / 25) for m = 0..25.
const LogTable& logTable() {
  static const auto table = [] {
    LogTable values{};
    for (std::size_t m = 0; m < values.size(); ++m) {
      values[m] =
          std::log(double(std::max<std::size_t>(m, 1)) / double(WindowCounts::kWindowPixelCount));
    }
    return values;
  }();
  return table;
}

/// Position in the image, row * columns + column, of the pixel that (column, row) lies in; rows *
/// columns outside. Pixel centers lie at integers: pixel k covers [k - 0.5, k + 0.5).
struct NearestPixelKernel {
  DEWPOINT_KERNEL void run(std::int64_t count, const double* __restrict columns,
                           const double* __restrict rows, int width, int height,
                           std::int32_t* __restrict pixels) {
    const double right = width;
    const double bottom = height;
    for (std::int64_t i = 0; i < count; ++i) {
      const double column = columns[i] + 0.5;
      const double row = rows[i] + 0.5;
      const bool inside = // false for NaN
          (column >= 0.0) & (column < right) & (row >= 0.0) & (row < bottom);
      const auto x = static_cast<std::int32_t>(inside ? column : 0.0);
      const auto y = static_cast<std::int32_t>(inside ? row : bottom);
      pixels[i] = y * width + x;
    }
  }
};

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
    view.counts.clear();
  }
}

void ColorWindow::setImage(std::size_t camera, const cv::Mat& image) {
  View& view = views_.at(camera);
  view.image = image.type() == CV_8UC3 ? image : cv::Mat();
  view.counts.clear();
}

void ColorWindow::prepare(std::int64_t windowCount) {
  for (View& view : views_) {
    const auto pixels = static_cast<std::int64_t>(view.image.total());
    if (windowCount * kPixelsPerWindow < pixels) {
      view.counts.clear();
    } else if (view.counts.empty() && pixels > 0) {
      view.counts.build(view.image, classifier_);
    }
  }
}

void ColorWindow::projectToPixels(const View& view, std::int64_t count, const double* x,
                                  const double* y, const double* z, std::int32_t* pixels) {
  std::array<double, kWindowBlock> columns;
  std::array<double, kWindowBlock> rows;
  view.projector.projectBatch(count, x, y, z, columns.data(), rows.data());
  runKernel<NearestPixelKernel>(count, columns.data(), rows.data(), view.image.cols,
                                view.image.rows, pixels);
}

void ColorWindow::addLogLikelihood(ConstStateRows rows, LogWeightSegment logLikelihood) const {
  const LogTable& logs = logTable();
  const double* x = rows.col(0).data();
  const double* y = rows.col(1).data();
  const double* z = rows.col(2).data();
  std::array<std::int32_t, kWindowBlock> pixels;
  std::array<std::uint8_t, kWindowBlock> counts;
  for (Eigen::Index begin = 0; begin < rows.rows(); begin += kWindowBlock) {
    const int count = static_cast<int>(std::min<Eigen::Index>(kWindowBlock, rows.rows() - begin));
    double* out = logLikelihood.data() + begin;
    for (const View& view : views_) {
      if (view.image.empty()) {
        continue;
      }
      projectToPixels(view, count, x + begin, y + begin, z + begin, pixels.data());
      if (view.counts.empty()) {
        countWindows(view.image, classifier_, count, pixels.data(), counts.data());
        for (int i = 0; i < count; ++i) {
          out[i] += logs[counts[std::size_t(i)]];
        }
      } else {
        const std::uint8_t* all = view.counts.data();
        for (int i = 0; i < count; ++i) {
          out[i] += logs[all[pixels[std::size_t(i)]]];
        }
      }
    }
  }
}

std::optional<int> ColorWindow::matchCount(std::size_t camera,
                                           const Eigen::Vector3d& pointWorld) const {
  const View& view = views_.at(camera);
  if (view.image.empty()) {
    return std::nullopt;
  }
  std::int32_t pixel = 0;
  projectToPixels(view, 1, &pointWorld.x(), &pointWorld.y(), &pointWorld.z(), &pixel);
  if (pixel >= static_cast<std::int64_t>(view.image.total())) {
    return std::nullopt;
  }
  return countWindow(view.image, classifier_, pixel % view.image.cols, pixel / view.image.cols);
}

} // namespace dewpoint::observation
