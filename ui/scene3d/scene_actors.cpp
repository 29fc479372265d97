// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/scene_actors.h"

#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace dewpoint::ui {
namespace {

void appendCells(const std::vector<std::vector<Eigen::Vector3d>>& shapes, vtkPoints* points,
                 vtkCellArray* cells) {
  for (const auto& shape : shapes) {
    cells->InsertNextCell(static_cast<int>(shape.size()));
    for (const Eigen::Vector3d& point : shape) {
      cells->InsertCellPoint(points->InsertNextPoint(point.data()));
    }
  }
}

bool allFinite(const std::vector<Eigen::Vector3d>& points) {
  return std::all_of(points.begin(), points.end(),
                     [](const Eigen::Vector3d& point) { return point.allFinite(); });
}

} // namespace

double ScreenScale::lengthInMeters(const Eigen::Vector3d& point, double pixels) const {
  const double perPixel =
      isParallel ? metersPerPixel : metersPerPixelAndDepth * std::max(depth(point), 1e-3);
  return pixels * pixelRatio * perPixel;
}

Eigen::Vector2d ScreenScale::project(const Eigen::Vector3d& point) const {
  const double perPixel =
      isParallel ? metersPerPixel : metersPerPixelAndDepth * std::max(depth(point), 1e-3);
  return Eigen::Vector2d((point - eye).dot(right), (point - eye).dot(up)) / perPixel;
}

Eigen::Vector3d ScreenScale::unproject(const Eigen::Vector2d& place,
                                       const Eigen::Vector3d& like) const {
  const double perPixel =
      isParallel ? metersPerPixel : metersPerPixelAndDepth * std::max(depth(like), 1e-3);
  return eye + depth(like) * direction + perPixel * (place.x() * right + place.y() * up);
}

double ScreenScale::scaleToMoveCloser(const Eigen::Vector3d& point, double distance) const {
  const double away = (point - eye).norm();
  return isParallel || away <= 0.0 ? 1.0 : std::clamp(1.0 - distance / away, 0.3, 1.0);
}

Eigen::Vector3d ScreenScale::movedCloser(const Eigen::Vector3d& point, double distance) const {
  if (isParallel) {
    return point - direction * distance;
  }
  return eye + (point - eye) * scaleToMoveCloser(point, distance);
}

void addNewProp(vtkRenderer* renderer, vtkProp* prop) {
  renderer->GetViewProps()->AddItem(prop);
  prop->AddConsumer(renderer);
}

vtkSmartPointer<vtkActor> makeFlatActor(vtkPolyData* data) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->PickableOff();
  return actor;
}

vtkSmartPointer<vtkActor> addNewActor(vtkRenderer* renderer, vtkPolyData* data) {
  auto actor = makeFlatActor(data);
  actor->ForceTranslucentOn();
  actor->VisibilityOff();
  addNewProp(renderer, actor);
  return actor;
}

void setActorColor(vtkActor* actor, const SceneColor& color, double opacity) {
  actor->GetProperty()->SetColor(color.x(), color.y(), color.z());
  actor->GetProperty()->SetOpacity(opacity);
}

std::array<unsigned char, 3> colorBytes(const SceneColor& color) {
  std::array<unsigned char, 3> bytes{};
  for (int i = 0; i < 3; ++i) {
    bytes[static_cast<std::size_t>(i)] =
        static_cast<unsigned char>(std::lround(255.0 * std::clamp(color[i], 0.0, 1.0)));
  }
  return bytes;
}

LinesAndFaces::LinesAndFaces() = default;

void LinesAndFaces::addLine(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  addPolyline({from, to});
}

void LinesAndFaces::addPolyline(const std::vector<Eigen::Vector3d>& points) {
  if (points.size() > 1 && allFinite(points)) {
    lines_.push_back(points);
  }
}

void LinesAndFaces::addFace(const std::vector<Eigen::Vector3d>& corners) {
  if (corners.size() > 2 && allFinite(corners)) {
    faces_.push_back(corners);
  }
}

void LinesAndFaces::writeTo(vtkPolyData* data) const {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkCellArray> faces;
  appendCells(lines_, points, lines);
  appendCells(faces_, points, faces);
  data->SetPoints(points);
  data->SetLines(lines);
  data->SetPolys(faces);
}

SceneLabels::SceneLabels(vtkRenderer* renderer) : renderer_(renderer) {}

SceneLabels::~SceneLabels() {
  clear();
}

void SceneLabels::clear() {
  for (const Label& label : labels_) {
    renderer_->RemoveActor2D(label.actor);
  }
  labels_.clear();
}

void SceneLabels::add(const std::string& text, const Eigen::Vector3d& point, double sizePx,
                      double right, double up) {
  if (text.empty() || !point.allFinite()) {
    return;
  }
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(text.c_str());
  actor->SetTextScaleModeToNone();
  actor->PickableOff();
  actor->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  actor->GetPositionCoordinate()->SetValue(point.x(), point.y(), point.z());
  vtkTextProperty* style = actor->GetTextProperty();
  style->SetFontFamilyToArial();
  style->SetVerticalJustificationToCentered();
  if (right > 0.0) {
    style->SetJustificationToLeft();
  } else if (right < 0.0) {
    style->SetJustificationToRight();
  } else {
    style->SetJustificationToCentered();
  }
  labels_.push_back({actor, point, sizePx, right, up});
  paintLabel(labels_.back());
  renderer_->AddActor2D(actor);
}

void SceneLabels::setColors(const SceneColor& text, const SceneColor& background) {
  text_ = text;
  background_ = background;
  for (const Label& label : labels_) {
    paintLabel(label);
  }
}

void SceneLabels::paintLabel(const Label& label) const {
  vtkTextProperty* style = label.actor->GetTextProperty();
  style->SetColor(text_.x(), text_.y(), text_.z());
  style->SetBackgroundColor(background_.x(), background_.y(), background_.z());
  style->SetBackgroundOpacity(0.55);
}

void SceneLabels::appendTextAreas(const ScreenScale& scale,
                                  std::vector<Eigen::AlignedBox2d>& places) const {
  constexpr double kCharacter = 0.6; // of the height, wide
  for (const Label& label : labels_) {
    if (label.actor->GetVisibility() == 0) {
      continue;
    }
    const double height = label.sizePx * scale.pixelRatio;
    const double width =
        kCharacter * height * static_cast<double>(std::string_view(label.actor->GetInput()).size());
    const double side = label.rightOffsetInTextHeights > 0.0   ? 0.5
                        : label.rightOffsetInTextHeights < 0.0 ? -0.5
                                                               : 0.0;
    const Eigen::Vector2d center =
        scale.project(label.point) +
        height * Eigen::Vector2d(label.rightOffsetInTextHeights, label.upOffsetInTextHeights) +
        Eigen::Vector2d(side * width, 0.0);
    const Eigen::Vector2d half(0.5 * width, 0.5 * height);
    places.emplace_back(Eigen::Vector2d(center - half), Eigen::Vector2d(center + half));
  }
}

void SceneLabels::prepareRendering(const ScreenScale& scale) {
  for (const Label& label : labels_) {
    // 2D text is projected through the eye too: behind it, it would appear mirrored.
    label.actor->SetVisibility(visible_ && (scale.isParallel || scale.depth(label.point) > 0.05));
    const double height = scale.lengthInMeters(label.point, label.sizePx);
    const Eigen::Vector3d place = label.point + (scale.right * label.rightOffsetInTextHeights +
                                                 scale.up * label.upOffsetInTextHeights) *
                                                    height;
    label.actor->GetPositionCoordinate()->SetValue(place.x(), place.y(), place.z());
    label.actor->GetTextProperty()->SetFontSize(
        std::max(1, static_cast<int>(std::lround(label.sizePx * scale.pixelRatio))));
  }
}

} // namespace dewpoint::ui
