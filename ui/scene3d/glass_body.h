// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/scene_actors.h"

#include <vtkActor.h>
#include <vtkSmartPointer.h>

class vtkRenderer;

namespace dewpoint::ui {

/// Sphere or ellipsoid drawn as one layer of glass, faint at its center and strong toward its rim.
/// Two layers form a transparent body; the content is drawn between the two.
class GlassBody {
public:
  enum class Layer {
    Fill, ///< whole body, with a highlight
    Rim   ///< only the rim, drawn over the content
  };
  GlassBody(vtkRenderer* renderer, Layer layer);
  ~GlassBody();
  GlassBody(const GlassBody&) = delete;
  GlassBody& operator=(const GlassBody&) = delete;

  void setVisible(bool visible) { actor_->SetVisibility(visible); }
  /// Sets the colors and opacities (0 to 1) of the center (`color`, `middle`) and the rim (`rim`,
  /// `atRim`). The layer Rim has no center.
  void setAppearance(const SceneColor& color, const SceneColor& rim, double middle, double atRim);
  /// Places the body at `center`. The columns of `directions` are the axes, right-handed. World
  /// coordinates, meters.
  void setPose(const Eigen::Vector3d& center, const Eigen::Matrix3d& directions,
               const Eigen::Vector3d& semiAxes, const ScreenScale& scale);

private:
  vtkRenderer* renderer_;
  vtkSmartPointer<vtkActor> actor_;
};

} // namespace dewpoint::ui
