// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/scene_actors.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

class vtkRenderer;

namespace dewpoint::ui {

/// Shadow of an object on the floor z = 0: a soft dark disc below the object and a thin plumb line.
/// Together they show its position and height.
class FloorShadow {
public:
  explicit FloorShadow(vtkRenderer* renderer);
  ~FloorShadow();
  FloorShadow(const FloorShadow&) = delete;
  FloorShadow& operator=(const FloorShadow&) = delete;

  /// Shows the shadow below `point` of an object with this radius. World coordinates, meters.
  void show(const Eigen::Vector3d& point, double radius);
  void hide();
  void setColors(const SceneColor& plumb, bool darkBackground);
  void prepareRendering(const ScreenScale& scale);

private:
  void drawDisc(bool darkBackground);

  vtkRenderer* renderer_;
  Eigen::Vector3d point_ = Eigen::Vector3d::Zero();
  double radius_ = 0.0;
  vtkNew<vtkPolyData> discData_;
  vtkNew<vtkPolyData> plumbData_;
  vtkSmartPointer<vtkActor> disc_;
  vtkSmartPointer<vtkActor> plumb_;
};

} // namespace dewpoint::ui
