// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "ui/scene3d/camera_glyph.h"
#include "ui/scene3d/scene_actors.h"

#include <vtkPolyData.h>

#include <vector>

namespace dewpoint::ui {

/// Cameras of a rig drawn as viewing pyramids, with plumb lines to the floor. Camera names are
/// painted over the rendered image.
class CameraFrusta {
public:
  explicit CameraFrusta(vtkRenderer* renderer);
  /// Shows a rig. `length` is the distance from the optical center to the image, in meters. Omits
  /// cameras with an invalid pose or without intrinsics.
  void show(const CameraRig& rig, double length);
  const std::vector<CameraGlyph>& glyphs() const { return glyphs_; }
  void setPalette(const ScenePalette& palette);
  void prepareFrame(const ScreenScale& scale);

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
