// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "ui/scene3d/scene_actors.h"

#include <vtkPolyData.h>

namespace dewpoint::ui {

/// Every camera of a rig as the pyramid it looks through, with its name.
class CameraFrusta {
public:
  explicit CameraFrusta(vtkRenderer* renderer);
  /// `length`: from the optical center to the image, meters. Cameras with an unusable pose or
  /// without intrinsics are left out.
  void show(const CameraRig& rig, double length);
  void setPalette(const ScenePalette& palette);
  void prepareFrame(const ScreenScale& scale);

private:
  vtkNew<vtkPolyData> edgeData_;
  vtkNew<vtkPolyData> faceData_;
  vtkSmartPointer<vtkActor> edges_;
  vtkSmartPointer<vtkActor> faces_;
  SceneLabels labels_;
};

} // namespace dewpoint::ui
