// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/scene_actors.h"

#include <Eigen/Geometry>
#include <vtkPolyData.h>

#include <vector>

namespace dewpoint::ui {

/// Thin single-color lines with constant width on the screen.
class WireActor {
public:
  /// Creates an actor without lines. `widthPx` is the line width in logical pixels.
  WireActor(vtkRenderer* renderer, double widthPx);
  ~WireActor();
  WireActor(const WireActor&) = delete;
  WireActor& operator=(const WireActor&) = delete;

  /// Shows one line per list of points (meters). Replaces all earlier lines.
  void show(const std::vector<std::vector<Eigen::Vector3d>>& lines);
  /// Returns the bounding box of all lines in meters; empty without lines.
  const Eigen::AlignedBox3d& extent() const { return extent_; }
  void setColor(const SceneColor& color, double opacity);
  void prepareRendering(const ScreenScale& scale);

private:
  vtkRenderer* renderer_;
  double widthPx_;
  vtkNew<vtkPolyData> data_;
  vtkSmartPointer<vtkActor> actor_;
  Eigen::AlignedBox3d extent_;
};

} // namespace dewpoint::ui
