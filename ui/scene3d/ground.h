// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/scene_actors.h"

#include <Eigen/Geometry>
#include <vtkPolyData.h>

namespace dewpoint {

/// The floor z = 0: a faint plane, lines every 0.1 m or 1 m, numbers in metres along two edges, and
/// the axes at the origin.
class Ground {
public:
  explicit Ground(vtkRenderer* renderer);
  /// The rectangle to cover; rounded outwards to whole steps. Metres.
  void cover(const Eigen::AlignedBox2d& extent);
  void setPalette(const ScenePalette& palette);
  void prepareFrame(const ScreenScale& scale);
  /// What the floor covers, after rounding.
  const Eigen::AlignedBox2d& extent() const { return extent_; }

private:
  void drawPlane();
  void drawLines();
  void drawNumbers();
  void drawAxes();

  vtkNew<vtkPolyData> planeData_;
  vtkNew<vtkPolyData> minorData_;
  vtkNew<vtkPolyData> majorData_;
  vtkNew<vtkPolyData> axisData_[3];
  vtkSmartPointer<vtkActor> plane_;
  vtkSmartPointer<vtkActor> minor_;
  vtkSmartPointer<vtkActor> major_;
  vtkSmartPointer<vtkActor> axes_[3];
  SceneLabels labels_;
  Eigen::AlignedBox2d extent_;
  double majorStep_ = 1.0;
  double minorStep_ = 0.1;
};

} // namespace dewpoint
