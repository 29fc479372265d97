// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/ground.h"

#include <fmt/format.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace dewpoint {
namespace {

constexpr const char* kAxisNames[3] = {"x", "y", "z"};

/// Lines parallel to both axes at the multiples of `step` inside `extent`.
void gridLines(const Eigen::AlignedBox2d& extent, double step, double z, vtkPolyData* data) {
  Strokes strokes;
  for (int axis = 0; axis < 2; ++axis) {
    const int other = 1 - axis;
    const auto first = std::llround(std::ceil(extent.min()[axis] / step - 1e-6));
    const auto last = std::llround(std::floor(extent.max()[axis] / step + 1e-6));
    for (auto i = first; i <= last; ++i) {
      Eigen::Vector3d from(0.0, 0.0, z);
      from[axis] = static_cast<double>(i) * step;
      Eigen::Vector3d to = from;
      from[other] = extent.min()[other];
      to[other] = extent.max()[other];
      strokes.line(from, to);
    }
  }
  strokes.writeTo(data);
}

std::string metres(double value, double step) {
  return fmt::format("{:.{}f}", value == 0.0 ? 0.0 : value, step < 0.95 ? 1 : 0);
}

} // namespace

Ground::Ground(vtkRenderer* renderer)
    : plane_(flatActor(planeData_)), minor_(flatActor(minorData_)), major_(flatActor(majorData_)),
      labels_(renderer) {
  renderer->AddActor(plane_);
  renderer->AddActor(minor_);
  renderer->AddActor(major_);
  for (int axis = 0; axis < 3; ++axis) {
    axes_[axis] = flatActor(axisData_[axis]);
    renderer->AddActor(axes_[axis]);
  }
}

void Ground::cover(const Eigen::AlignedBox2d& extent) {
  const double size = extent.sizes().maxCoeff();
  majorStep_ = size > 60.0 ? 10.0 : size > 1.2 ? 1.0 : 0.1;
  minorStep_ = size > 60.0 ? 10.0 : size > 6.5 ? 1.0 : 0.1;
  const double rounding = majorStep_ / (majorStep_ > 0.5 ? 2.0 : 1.0);
  const Eigen::Array2d low = (extent.min().array() / rounding - 1e-6).floor() * rounding;
  const Eigen::Array2d high = (extent.max().array() / rounding + 1e-6).ceil() * rounding;
  const Eigen::AlignedBox2d rounded(low.matrix(), high.matrix());
  if (!extent_.isEmpty() && rounded.isApprox(extent_, 1e-9)) {
    return;
  }
  extent_ = rounded;
  drawPlane();
  drawLines();
  drawNumbers();
  drawAxes();
}

// Plane, fine lines, lines and axes are stacked a little, so that none flickers through another.
void Ground::drawPlane() {
  const double z = -0.0015 * extent_.sizes().maxCoeff();
  const Eigen::Vector2d low = extent_.min();
  const Eigen::Vector2d high = extent_.max();
  Strokes strokes;
  strokes.face({{low.x(), low.y(), z},
                {high.x(), low.y(), z},
                {high.x(), high.y(), z},
                {low.x(), high.y(), z}});
  strokes.writeTo(planeData_);
}

void Ground::drawLines() {
  const double lift = 0.0005 * extent_.sizes().maxCoeff();
  minor_->SetVisibility(minorStep_ < majorStep_);
  gridLines(extent_, minorStep_, -lift, minorData_);
  gridLines(extent_, majorStep_, 0.0, majorData_);
}

void Ground::drawNumbers() {
  labels_.clear();
  const double size = extent_.sizes().maxCoeff();
  const double wanted = size / 9.0;
  double step = majorStep_;
  for (const double factor : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0}) {
    step = majorStep_ * factor;
    if (step >= wanted) {
      break;
    }
  }
  if (majorStep_ == 1.0 && size < 3.2) {
    step = 0.5;
  }
  for (int axis = 0; axis < 2; ++axis) {
    const int other = 1 - axis;
    const auto first = static_cast<long>(std::ceil(extent_.min()[axis] / step - 1e-6));
    const auto last = static_cast<long>(std::floor(extent_.max()[axis] / step + 1e-6));
    for (long i = first; i <= last; ++i) {
      const double value = static_cast<double>(i) * step;
      Eigen::Vector3d point = Eigen::Vector3d::Zero();
      point[axis] = value;
      point[other] = extent_.min()[other];
      const std::string unit = i == last ? " m" : "";
      labels_.add(metres(value, step) + unit, point, 11.0, axis == 1 ? -0.6 : 0.0,
                  axis == 0 ? -1.0 : 0.0);
    }
  }
}

void Ground::drawAxes() {
  const double size = extent_.sizes().maxCoeff();
  const double length = size > 60.0 ? 10.0 : size > 6.5 ? 1.0 : size > 2.0 ? 0.5 : 0.1;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d base(0.0, 0.0, 0.001 * size);
    const Eigen::Vector3d tip = base + Eigen::Vector3d::Unit(axis) * length;
    Strokes strokes;
    strokes.line(base, tip);
    strokes.writeTo(axisData_[axis]);
    labels_.add(kAxisNames[axis], base + Eigen::Vector3d::Unit(axis) * length * 1.12, 12.0);
  }
}

void Ground::setPalette(const ScenePalette& palette) {
  paint(plane_, palette.floor);
  paint(minor_, palette.gridMinor);
  paint(major_, palette.gridMajor);
  for (int axis = 0; axis < 3; ++axis) {
    paint(axes_[axis], axisColor(axis));
  }
  labels_.setColors(palette.text, palette.background);
}

void Ground::prepareFrame(const ScreenScale& scale) {
  const auto width = [&](double pixels) { return static_cast<float>(pixels * scale.pixelRatio); };
  minor_->GetProperty()->SetLineWidth(width(1.0));
  major_->GetProperty()->SetLineWidth(width(1.0));
  for (const auto& axis : axes_) {
    axis->GetProperty()->SetLineWidth(width(2.5));
  }
  labels_.prepareFrame(scale);
}

} // namespace dewpoint
