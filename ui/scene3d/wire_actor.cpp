// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/wire_actor.h"

#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace dewpoint::ui {

WireActor::WireActor(vtkRenderer* renderer, double widthPx)
    : renderer_(renderer), widthPx_(widthPx), actor_(makeFlatActor(data_)) {
  actor_->VisibilityOff();
  addNewProp(renderer_, actor_);
}

WireActor::~WireActor() {
  renderer_->RemoveActor(actor_);
}

void WireActor::show(const std::vector<std::vector<Eigen::Vector3d>>& lines) {
  LinesAndFaces drawn;
  extent_.setEmpty();
  for (const auto& line : lines) {
    drawn.addPolyline(line);
    for (const Eigen::Vector3d& point : line) {
      extent_.extend(point);
    }
  }
  drawn.writeTo(data_);
  actor_->SetVisibility(!lines.empty());
}

void WireActor::setColor(const SceneColor& color, double opacity) {
  setActorColor(actor_, color, opacity);
}

void WireActor::prepareRendering(const ScreenScale& scale) {
  actor_->GetProperty()->SetLineWidth(static_cast<float>(widthPx_ * scale.pixelRatio));
}

} // namespace dewpoint::ui
