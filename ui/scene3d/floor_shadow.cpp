// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/floor_shadow.h"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace dewpoint::ui {
namespace {

constexpr int kAround = 36;
constexpr double kSmallestPx = 7.0; ///< radius
constexpr double kLarger = 1.25;    ///< than what throws it, with its soft rim
constexpr double kLiftPx = 0.6;     ///< above the lines of the floor
constexpr double kPlumbPx = 1.0;
/// Radius and opacity, relative to the outermost and the innermost ring.
constexpr std::array<std::array<double, 2>, 4> kRings{
    {{0.3, 1.0}, {0.6, 0.75}, {0.82, 0.3}, {1.0, 0.0}}};

} // namespace

FloorShadow::FloorShadow(vtkRenderer* renderer)
    : renderer_(renderer), disc_(addNewActor(renderer, discData_)),
      plumb_(addNewActor(renderer, plumbData_)) {
  drawDisc(false);
}

FloorShadow::~FloorShadow() {
  renderer_->RemoveActor(disc_);
  renderer_->RemoveActor(plumb_);
}

void FloorShadow::drawDisc(bool darkBackground) {
  const double strongest = darkBackground ? 150.0 : 70.0;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> faces;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(4);
  const auto add = [&](double x, double y, double opacity) {
    const std::array<unsigned char, 4> rgba{0, 0, 0,
                                            static_cast<unsigned char>(strongest * opacity)};
    colors->InsertNextTypedTuple(rgba.data());
    return points->InsertNextPoint(x, y, 0.0);
  };
  const vtkIdType middle = add(0.0, 0.0, 1.0);
  for (const auto& [radius, opacity] : kRings) {
    for (int k = 0; k < kAround; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kAround;
      add(radius * std::cos(angle), radius * std::sin(angle), opacity);
    }
  }
  const auto at = [&](std::size_t ring, int k) {
    return middle + 1 + static_cast<vtkIdType>(ring) * kAround + k % kAround;
  };
  for (int k = 0; k < kAround; ++k) {
    const std::array<vtkIdType, 3> wedge{middle, at(0, k), at(0, k + 1)};
    faces->InsertNextCell(3, wedge.data());
    for (std::size_t ring = 0; ring + 1 < kRings.size(); ++ring) {
      const std::array<vtkIdType, 4> patch{at(ring, k), at(ring + 1, k), at(ring + 1, k + 1),
                                           at(ring, k + 1)};
      faces->InsertNextCell(4, patch.data());
    }
  }
  discData_->SetPoints(points);
  discData_->SetPolys(faces);
  discData_->GetPointData()->SetScalars(colors);
}

void FloorShadow::show(const Eigen::Vector3d& point, double radius) {
  point_ = point;
  radius_ = radius;
  disc_->SetVisibility(point.z() > 0.0); // below the floor nothing throws a shadow on it
  plumb_->VisibilityOn();
  LinesAndFaces plumb;
  plumb.addLine(point, {point.x(), point.y(), 0.0});
  plumb.writeTo(plumbData_);
}

void FloorShadow::hide() {
  disc_->VisibilityOff();
  plumb_->VisibilityOff();
}

void FloorShadow::setColors(const SceneColor& plumb, bool darkBackground) {
  setActorColor(plumb_, plumb, 0.45);
  drawDisc(darkBackground);
}

void FloorShadow::prepareRendering(const ScreenScale& scale) {
  const Eigen::Vector3d below(point_.x(), point_.y(), 0.0);
  const double radius = std::max(kLarger * radius_, scale.lengthInMeters(below, kSmallestPx));
  disc_->SetPosition(below.x(), below.y(), scale.lengthInMeters(below, kLiftPx));
  disc_->SetScale(radius, radius, 1.0);
  plumb_->GetProperty()->SetLineWidth(static_cast<float>(kPlumbPx * scale.pixelRatio));
}

} // namespace dewpoint::ui
