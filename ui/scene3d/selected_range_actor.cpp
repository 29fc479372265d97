// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/selected_range_actor.h"

#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace dewpoint::ui {

namespace {
constexpr double kWidthPx = 7.0;
} // namespace

SelectedRangeActor::SelectedRangeActor(vtkRenderer* renderer)
    : renderer_(renderer), actor_(makeFlatActor(data_)) {
  actor_->VisibilityOff();
  renderer_->AddActor(actor_);
}

SelectedRangeActor::~SelectedRangeActor() {
  renderer_->RemoveActor(actor_);
}

void SelectedRangeActor::show(const std::vector<std::vector<Eigen::Vector3d>>& strokes) {
  LinesAndFaces drawn;
  for (const auto& stroke : strokes) {
    if (stroke.size() > 1) {
      drawn.addPolyline(stroke);
    } else if (stroke.size() == 1) {
      // A single place: a short cross, so that it is seen at all.
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d arm = 0.01 * Eigen::Vector3d::Unit(axis);
        drawn.addLine(stroke.front() - arm, stroke.front() + arm);
      }
    }
  }
  drawn.writeTo(data_);
  actor_->SetVisibility(!strokes.empty());
}

void SelectedRangeActor::setPalette(const ScenePalette& palette) {
  setActorColor(actor_, palette.truth, 0.6);
}

void SelectedRangeActor::prepareRendering(const ScreenScale& scale) {
  actor_->GetProperty()->SetLineWidth(static_cast<float>(kWidthPx * scale.pixelRatio));
}

} // namespace dewpoint::ui
