// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "ui/scene3d/camera_glyph.h"
#include "ui/scene3d/scene_actors.h"

#include <vtkPolyData.h>

#include <vector>

namespace dewpoint::ui {

/// Cameras of a rig, drawn in the scene as viewing pyramids with plumb lines to the floor. Camera
/// names are not part of the scene; they are painted over the rendered image.
class CameraFrusta {
public:
  explicit CameraFrusta(vtkRenderer* renderer);
  /// Shows the cameras of a rig. `length` is the length of the pyramids in meters. Cameras with an
  /// invalid pose or without intrinsics are omitted.
  void show(const CameraRig& rig, double length);
  const std::vector<CameraGlyph>& glyphs() const { return glyphs_; }
  void setPalette(const ScenePalette& palette);
  void prepareRendering(const ScreenScale& scale);

private:
  vtkNew<vtkPolyData> edgeData_;
  vtkNew<vtkPolyData> faceData_;
  vtkNew<vtkPolyData> plumbData_;
  vtkSmartPointer<vtkActor> edges_;
  vtkSmartPointer<vtkActor> faces_;
  vtkSmartPointer<vtkActor> plumbs_;
  std::vector<CameraGlyph> glyphs_;
};

} // namespace dewpoint::ui
