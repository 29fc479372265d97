// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/ground.h"

#include <fmt/format.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {
namespace {

constexpr const char* kAxisNames[3] = {"x", "y", "z"};

/// Lines at the multiples of `step` inside `extent`, which spans the world axes `u` and `v`;
/// `level` is the third coordinate.
void gridLines(const Eigen::AlignedBox2d& extent, int u, int v, double level, double step,
               vtkPolyData* data) {
  const int axes[2] = {u, v};
  LinesAndFaces strokes;
  for (int i = 0; i < 2; ++i) {
    const auto first = std::llround(std::ceil(extent.min()[i] / step - 1e-6));
    const auto last = std::llround(std::floor(extent.max()[i] / step + 1e-6));
    for (auto k = first; k <= last; ++k) {
      Eigen::Vector3d from = Eigen::Vector3d::Constant(level);
      from[axes[i]] = static_cast<double>(k) * step;
      Eigen::Vector3d to = from;
      from[axes[1 - i]] = extent.min()[1 - i];
      to[axes[1 - i]] = extent.max()[1 - i];
      strokes.addLine(from, to);
    }
  }
  strokes.writeTo(data);
}

double numberStep(double size, double majorStep) {
  if (majorStep == 1.0 && size < 3.2) {
    return 0.5;
  }
  for (const double factor : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0}) {
    if (majorStep * factor >= size / 9.0) {
      return majorStep * factor;
    }
  }
  return majorStep * 100.0;
}

std::string meters(double value, double step, const std::string& decimalPoint) {
  std::string text = fmt::format("{:.{}f}", value == 0.0 ? 0.0 : value, step < 0.95 ? 1 : 0);
  if (const auto point = text.find('.'); point != std::string::npos) {
    text.replace(point, 1, decimalPoint);
  }
  return text;
}

constexpr double kNumberRoom = 20.0; ///< pixels from one number of an axis to the next
/// Pixels from the last but one number to the last, which is wider by its unit, side by side.
constexpr double kUnitRoom = 34.0;
constexpr double kLineRoom = 14.0; ///< pixels from one line of text to the next
// Of the extent's size: the plane lies so far below the lines, and below what is lowest.
constexpr double kPlaneBelow = 0.0015;
constexpr double kMarginBelow = 0.01;

} // namespace

Ground::Ground(vtkRenderer* renderer)
    : plane_(makeFlatActor(planeData_)), minor_(makeFlatActor(minorData_)),
      major_(makeFlatActor(majorData_)), wallMinor_{makeFlatActor(wallMinorData_[0]),
                                                    makeFlatActor(wallMinorData_[1])},
      wallMajor_{makeFlatActor(wallMajorData_[0]), makeFlatActor(wallMajorData_[1])},
      numbers_{SceneLabels(renderer), SceneLabels(renderer), SceneLabels(renderer)},
      names_{SceneLabels(renderer), SceneLabels(renderer), SceneLabels(renderer)} {
  renderer->AddActor(plane_);
  renderer->AddActor(minor_);
  renderer->AddActor(major_);
  for (int wall = 0; wall < 2; ++wall) {
    renderer->AddActor(wallMinor_[wall]);
    renderer->AddActor(wallMajor_[wall]);
  }
  for (int axis = 0; axis < 3; ++axis) {
    axes_[axis] = makeFlatActor(axisData_[axis]);
    renderer->AddActor(axes_[axis]);
  }
}

void Ground::cover(const Eigen::AlignedBox2d& extent, double height, double lowest) {
  const double size = extent.sizes().maxCoeff();
  majorStep_ = size > 60.0 ? 10.0 : size > 1.2 ? 1.0 : 0.1;
  minorStep_ = size > 60.0 ? 10.0 : size > 6.5 ? 1.0 : 0.1;
  const double rounding = majorStep_ / (majorStep_ > 0.5 ? 2.0 : 1.0);
  const Eigen::Array2d low = (extent.min().array() / rounding - 1e-6).floor() * rounding;
  const Eigen::Array2d high = (extent.max().array() / rounding + 1e-6).ceil() * rounding;
  const Eigen::AlignedBox2d rounded(low.matrix(), high.matrix());
  const double roundedHeight = std::max(rounding, std::ceil(height / rounding - 1e-6) * rounding);
  const double plane = std::min(-kPlaneBelow * size, lowest - kMarginBelow * size);
  if (!extent_.isEmpty() && rounded.isApprox(extent_, 1e-9) && roundedHeight == height_ &&
      plane >= planeHeight_) {
    return;
  }
  planeHeight_ = plane;
  extent_ = rounded;
  height_ = roundedHeight;
  numberStep_ = numberStep(size, majorStep_);
  numberSteps_.setConstant(numberStep_);
  drawPlane();
  drawLines();
  drawNumbers();
  drawWalls();
  drawAxes();
}

// Plane, fine lines, lines and axes are stacked a little, so that none flickers through another.
void Ground::drawPlane() {
  const double z = planeHeight_;
  const Eigen::Vector2d low = extent_.min();
  const Eigen::Vector2d high = extent_.max();
  LinesAndFaces strokes;
  strokes.addFace({{low.x(), low.y(), z},
                   {high.x(), low.y(), z},
                   {high.x(), high.y(), z},
                   {low.x(), high.y(), z}});
  strokes.writeTo(planeData_);
}

void Ground::drawLines() {
  const double lift = 0.0005 * extent_.sizes().maxCoeff();
  gridLines(extent_, 0, 1, -lift, minorStep_, minorData_);
  gridLines(extent_, 0, 1, 0.0, majorStep_, majorData_);
}

void Ground::drawNumbers() {
  const Eigen::Vector3d low(extent_.min().x(), extent_.min().y(), 0.0);
  const Eigen::Vector3d high(extent_.max().x(), extent_.max().y(), height_);
  for (int axis = 0; axis < 3; ++axis) {
    numbers_[axis].clear();
    const double step = numberSteps_[axis];
    const auto first = static_cast<long>(std::ceil(low[axis] / step - 1e-6));
    const auto last = static_cast<long>(std::floor(high[axis] / step + 1e-6));
    for (long i = first; i <= last; ++i) {
      if (isUnitCrowded_[static_cast<std::size_t>(axis)] && i == last - 1 && i != first) {
        continue; // the last number, with the unit, needs its place
      }
      const double value = static_cast<double>(i) * step;
      Eigen::Vector3d point(low.x(), low.y(), 0.0);
      point[axis] = value;
      const std::string text = meters(value, step, decimalPoint_) + (i == last ? " m" : "");
      if (axis == 0 || (axis == 1 && isFromSide_)) { // below the edge of the floor
        numbers_[axis].add(text, point, 11.0, 0.0, -1.0);
      } else {
        numbers_[axis].add(text, point, 11.0, -0.6);
      }
    }
  }
}

void Ground::thinNumbers(const ScreenScale& scale) {
  if (extent_.isEmpty()) {
    return;
  }
  const Eigen::Vector3d corner(extent_.min().x(), extent_.min().y(), 0.0);
  const Eigen::Vector3d opposite(extent_.max().x(), extent_.max().y(), height_);
  Eigen::Vector3d steps = Eigen::Vector3d::Constant(numberStep_);
  std::array<bool, 3> crowded{};
  for (int axis = 0; axis < 3; ++axis) {
    Eigen::Vector3d end = corner;
    end[axis] = opposite[axis];
    const double length = end[axis] - corner[axis];
    const Eigen::Vector2d edge = (scale.project(end) - scale.project(corner)) / scale.pixelRatio;
    const double pixels = edge.norm();
    const double needed = kNumberRoom * length / std::max(pixels, 1.0);
    for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
      steps[axis] = numberStep_ * factor;
      if (steps[axis] >= needed) {
        break;
      }
    }
    const Eigen::Vector2d way = edge * (steps[axis] / std::max(length, 1e-9));
    crowded[static_cast<std::size_t>(axis)] =
        std::abs(way.x()) < kUnitRoom && std::abs(way.y()) < kLineRoom;
  }
  if (steps != numberSteps_ || crowded != isUnitCrowded_) {
    numberSteps_ = steps;
    isUnitCrowded_ = crowded;
    drawNumbers();
  }
}

// Each is behind the room for who looks along its normal, with the fine lines behind the others.
void Ground::drawWalls() {
  const double size = extent_.sizes().maxCoeff();
  const double behind = 0.01 * size;
  const double lift = 0.0005 * size;
  const double back[2] = {extent_.max().y() + behind, extent_.min().x() - behind};
  const double away[2] = {lift, -lift};
  for (int wall = 0; wall < 2; ++wall) {
    const Eigen::AlignedBox2d area(Eigen::Vector2d(extent_.min()[wall], 0.0),
                                   Eigen::Vector2d(extent_.max()[wall], height_));
    gridLines(area, wall, 2, back[wall] + away[wall], minorStep_, wallMinorData_[wall]);
    gridLines(area, wall, 2, back[wall], majorStep_, wallMajorData_[wall]);
  }
}

void Ground::drawAxes() {
  const double size = extent_.sizes().maxCoeff();
  const double length = size > 60.0 ? 10.0 : size > 6.5 ? 1.0 : size > 2.0 ? 0.5 : 0.1;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d base(0.0, 0.0, 0.001 * size);
    const Eigen::Vector3d tip = base + Eigen::Vector3d::Unit(axis) * length;
    LinesAndFaces strokes;
    strokes.addLine(base, tip);
    strokes.writeTo(axisData_[axis]);
    names_[axis].clear();
    names_[axis].add(kAxisNames[axis], base + Eigen::Vector3d::Unit(axis) * length * 1.12, 12.0);
  }
}

void Ground::setDecimalPoint(const std::string& sign) {
  if (sign != decimalPoint_) {
    decimalPoint_ = sign;
    drawNumbers();
  }
}

void Ground::setPalette(const ScenePalette& palette) {
  setActorColor(plane_, palette.floor);
  setActorColor(minor_, palette.gridMinor);
  setActorColor(major_, palette.gridMajor);
  for (int axis = 0; axis < 3; ++axis) {
    setActorColor(axes_[axis], axisColor(axis));
  }
  for (int wall = 0; wall < 2; ++wall) {
    setActorColor(wallMinor_[wall], palette.gridMinor);
    setActorColor(wallMajor_[wall], palette.gridMajor);
  }
  for (int axis = 0; axis < 3; ++axis) {
    numbers_[axis].setColors(palette.text, palette.background);
    names_[axis].setColors(palette.text, palette.floor);
  }
}

void Ground::appendTextAreas(const ScreenScale& scale,
                             std::vector<Eigen::AlignedBox2d>& places) const {
  for (int axis = 0; axis < 3; ++axis) {
    names_[axis].appendTextAreas(scale, places);
    numbers_[axis].appendTextAreas(scale, places);
  }
}

void Ground::prepareRendering(const ScreenScale& scale) {
  const auto width = [&](double pixels) { return static_cast<float>(pixels * scale.pixelRatio); };
  minor_->GetProperty()->SetLineWidth(width(1.0));
  major_->GetProperty()->SetLineWidth(width(1.6));
  const bool fromFront = scale.isParallel && std::abs(scale.direction.y()) > 0.99;
  const bool fromSide = scale.isParallel && std::abs(scale.direction.x()) > 0.99;
  const bool isWallShown[2] = {fromFront, fromSide};
  for (int wall = 0; wall < 2; ++wall) {
    wallMinor_[wall]->SetVisibility(isWallShown[wall] && minorStep_ < majorStep_);
    wallMajor_[wall]->SetVisibility(isWallShown[wall]);
    wallMinor_[wall]->GetProperty()->SetLineWidth(width(1.0));
    wallMajor_[wall]->GetProperty()->SetLineWidth(width(1.6));
  }
  minor_->SetVisibility(!fromFront && !fromSide && minorStep_ < majorStep_);
  for (const auto& axis : axes_) {
    axis->GetProperty()->SetLineWidth(width(2.5));
  }
  if (fromSide != isFromSide_ && !extent_.isEmpty()) {
    isFromSide_ = fromSide;
    drawNumbers();
  }
  thinNumbers(scale);
  for (int axis = 0; axis < 3; ++axis) {
    // Along the line of sight, texts would pile up in one place.
    const bool across = std::abs(scale.direction[axis]) < 0.97;
    names_[axis].setVisible(across);
    numbers_[axis].setVisible(axis == 2 ? fromFront || fromSide : across);
    names_[axis].prepareRendering(scale);
    numbers_[axis].prepareRendering(scale);
  }
}

} // namespace dewpoint::ui
