// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/scene_actors.h"

#include <vtkActor.h>
#include <vtkSmartPointer.h>

class vtkRenderer;

namespace dewpoint::ui {

/// A ball or an ellipsoid as one layer of glass: faint where it is looked through, and strong
/// towards its rim. Two of them, with what is inside drawn between, are a body that hides nothing.
class GlassBody {
public:
  enum class Layer {
    Fill, ///< all of it, with a gleam
    Rim   ///< only the rim, to be drawn over what is inside
  };
  GlassBody(vtkRenderer* renderer, Layer layer);
  ~GlassBody();
  GlassBody(const GlassBody&) = delete;
  GlassBody& operator=(const GlassBody&) = delete;

  void setVisible(bool visible) { actor_->SetVisibility(visible); }
  /// Opacities of the middle (Fill only) and of the rim, 0 to 1.
  void setLook(const SceneColor& color, const SceneColor& rim, double middle, double atRim);
  /// Around `center`; the columns of `directions` are the axes, right-handed. Meters.
  void place(const Eigen::Vector3d& center, const Eigen::Matrix3d& directions,
             const Eigen::Vector3d& semiAxes, const ScreenScale& scale);

private:
  vtkRenderer* renderer_;
  vtkSmartPointer<vtkActor> actor_;
};

} // namespace dewpoint::ui
