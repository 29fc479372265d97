// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/scene_actors.h"

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointGaussianMapper.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <vector>

class vtkRenderer;

namespace dewpoint::ui {

/// Particles as small discs of constant size on the screen, colored by weight, the heaviest on top.
/// Drawn over everything added before, regardless of depth, unless that is opaque.
class ParticleCloud {
public:
  explicit ParticleCloud(vtkRenderer* renderer);
  ~ParticleCloud();
  ParticleCloud(const ParticleCloud&) = delete;
  ParticleCloud& operator=(const ParticleCloud&) = delete;

  /// Shows one particle per row: x, y, z in meters, and its weight (linear). All weights are equal
  /// if there are fewer weights than rows. Particles that are not finite are left out, and so are
  /// some if there are too many.
  void show(const Eigen::ArrayXXd& rows, const Eigen::ArrayXd& weights);
  void hide() { actor_->VisibilityOff(); }
  void setColors(const SceneColor& unlikely, const SceneColor& likely);
  /// `about`: position of the cloud, world coordinates.
  void prepareFrame(const ScreenScale& scale, const Eigen::Vector3d& about);

private:
  void colorParticles();

  vtkRenderer* renderer_;
  SceneColor unlikely_ = SceneColor::Zero();
  SceneColor likely_ = SceneColor::Zero();
  std::vector<float> brightness_; ///< one per drawn particle, 0 to 1, ascending
  vtkNew<vtkFloatArray> positions_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkUnsignedCharArray> colors_;
  vtkNew<vtkPolyData> data_;
  vtkNew<vtkPointGaussianMapper> mapper_;
  vtkNew<vtkActor> actor_;
};

} // namespace dewpoint::ui
