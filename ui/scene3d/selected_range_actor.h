// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/scene_actors.h"

#include <vtkPolyData.h>

#include <vector>

namespace dewpoint::ui {

/// Selected part of a trajectory, drawn as a wide line under the tail (the recent path of the
/// target).
class SelectedRangeActor {
public:
  explicit SelectedRangeActor(vtkRenderer* renderer);
  ~SelectedRangeActor();
  SelectedRangeActor(const SelectedRangeActor&) = delete;
  SelectedRangeActor& operator=(const SelectedRangeActor&) = delete;

  /// Shows the selected part: one line per list of positions (meters).
  void show(const std::vector<std::vector<Eigen::Vector3d>>& strokes);
  void setPalette(const ScenePalette& palette);
  void prepareRendering(const ScreenScale& scale);

private:
  vtkRenderer* renderer_;
  vtkNew<vtkPolyData> data_;
  vtkSmartPointer<vtkActor> actor_;
};

} // namespace dewpoint::ui
