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

/// Particles in the scene, drawn as small discs of constant size on the screen and colored by
/// weight, with the highest weights on top. They cover everything that was added before, regardless
/// of depth, except opaque objects.
class ParticleCloud {
public:
  explicit ParticleCloud(vtkRenderer* renderer);
  ~ParticleCloud();
  ParticleCloud(const ParticleCloud&) = delete;
  ParticleCloud& operator=(const ParticleCloud&) = delete;

  /// Shows one particle per row: x, y, z in meters, and its weight (linear). If there are fewer
  /// weights than rows, all weights are equal. Particles that are not finite are omitted. If there
  /// are too many particles, some are omitted.
  void show(const Eigen::ArrayXXd& rows, const Eigen::ArrayXd& weights);
  void hide() { actor_->VisibilityOff(); }
  void setColors(const SceneColor& unlikely, const SceneColor& likely);
  /// Prepares the next rendering. `about` is the position of the cloud in world coordinates.
  void prepareRendering(const ScreenScale& scale, const Eigen::Vector3d& about);

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
