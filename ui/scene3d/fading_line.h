// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/scene_actors.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

class vtkRenderer;

namespace dewpoint::ui {

/// Line through a sequence of positions. It fades toward the oldest position and has an outline
/// under it.
class FadingLine {
public:
  /// Creates a line in the scene. `widthPx` is the line width, and `outlinePx` the outline width on
  /// each side (0: no outline), in logical pixels.
  FadingLine(vtkRenderer* renderer, double widthPx, double outlinePx);
  ~FadingLine();
  FadingLine(const FadingLine&) = delete;
  FadingLine& operator=(const FadingLine&) = delete;

  /// Shows positions in meters, oldest first. A position that is not finite leaves a gap, because
  /// the path is unknown there.
  void show(const std::vector<Eigen::Vector3d>& points);
  /// Sets the colors of the line and its outline at the newest position.
  void setColors(const SceneColor& line, const SceneColor& outline);
  void prepareRendering(const ScreenScale& scale);

private:
  void draw();

  vtkRenderer* renderer_;
  double widthPx_;
  double outlinePx_;
  SceneColor color_ = SceneColor::Zero();
  SceneColor outlineColor_ = SceneColor::Zero();
  std::vector<Eigen::Vector3d> points_;
  vtkNew<vtkPolyData> outlineData_;
  vtkNew<vtkPolyData> data_;
  vtkSmartPointer<vtkActor> outline_;
  vtkSmartPointer<vtkActor> line_;
};

} // namespace dewpoint::ui
