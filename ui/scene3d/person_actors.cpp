// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/person_actors.h"

#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace dewpoint::ui {
namespace {

constexpr double kAboveFloor = 0.004; ///< meters, so that curves are not drawn into the floor

void fillHull(const ConvexHull& hull, vtkPolyData* faces, vtkPolyData* edges) {
  LinesAndFaces filled;
  LinesAndFaces lines;
  for (const auto& face : hull.faces) {
    std::vector<Eigen::Vector3d> corners;
    corners.reserve(face.size());
    for (const int vertex : face) {
      corners.push_back(hull.vertices[static_cast<std::size_t>(vertex)]);
    }
    for (std::size_t k = 0; k < corners.size(); ++k) {
      // Every edge belongs to two faces, which go along it in opposite directions.
      if (face.at(k) < face.at((k + 1) % corners.size())) {
        lines.addLine(corners[k], corners[(k + 1) % corners.size()]);
      }
    }
    filled.addFace(corners);
  }
  filled.writeTo(faces);
  lines.writeTo(edges);
}

void drawCurves(const std::vector<LevelCurve>& curves, vtkPolyData* data) {
  LinesAndFaces strokes;
  for (const LevelCurve& curve : curves) {
    std::vector<Eigen::Vector3d> points;
    points.reserve(curve.size());
    for (const Eigen::Vector2d& point : curve) {
      points.emplace_back(point.x(), point.y(), kAboveFloor);
    }
    strokes.addPolyline(points);
  }
  strokes.writeTo(data);
}

} // namespace

PersonActors::PersonActors(vtkRenderer* renderer)
    : renderer_(renderer), palette_(scenePalette(false)), hull_(makeFlatActor(hullData_)),
      edges_(makeFlatActor(edgeData_)) {
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    curves_[k] = makeFlatActor(curveData_[k]);
    curves_[k]->VisibilityOff();
    addNewProp(renderer_, curves_[k]);
  }
  for (vtkActor* actor : {hull_.Get(), edges_.Get()}) {
    actor->VisibilityOff();
    addNewProp(renderer_, actor);
  }
}

PersonActors::~PersonActors() {
  for (const auto& curve : curves_) {
    renderer_->RemoveActor(curve);
  }
  renderer_->RemoveActor(hull_);
  renderer_->RemoveActor(edges_);
}

void PersonActors::show(const PersonShape* shape) {
  const bool solid = shape != nullptr && !shape->hull.faces.empty();
  hull_->SetVisibility(solid);
  edges_->SetVisibility(solid);
  if (solid) {
    fillHull(shape->hull, hullData_, edgeData_);
  }
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    const bool any =
        shape != nullptr && k < shape->groundCurves.size() && !shape->groundCurves[k].empty();
    curves_[k]->SetVisibility(any);
    if (any) {
      drawCurves(shape->groundCurves[k], curveData_[k]);
    }
  }
}

void PersonActors::setChosen(bool chosen) {
  if (chosen_ != chosen) {
    chosen_ = chosen;
    repaint();
  }
}

void PersonActors::setColor(const SceneColor& color, const ScenePalette& palette) {
  color_ = color;
  palette_ = palette;
  repaint();
}

void PersonActors::repaint() {
  setActorColor(hull_, color_, chosen_ ? 0.3 : 0.16);
  setActorColor(edges_, mix(color_, palette_.truth, 0.1), chosen_ ? 0.55 : 0.25);
  for (std::size_t k = 0; k < curves_.size(); ++k) {
    // The innermost is the strongest: most of the person stands within it.
    const double outward = static_cast<double>(k) / static_cast<double>(curves_.size());
    setActorColor(curves_[k],
                  mix(mix(color_, palette_.truth, 0.15), palette_.floor, 0.45 * outward));
  }
}

void PersonActors::prepareRendering(const ScreenScale& scale) {
  const auto width = [&](double pixels) { return static_cast<float>(pixels * scale.pixelRatio); };
  edges_->GetProperty()->SetLineWidth(width(0.8));
  for (const auto& curve : curves_) {
    curve->GetProperty()->SetLineWidth(width(chosen_ ? 2.6 : 1.8));
  }
}

} // namespace dewpoint::ui
