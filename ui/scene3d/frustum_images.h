// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"
#include "ui/scene3d/camera_glyph.h"

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTexture.h>

#include <cstddef>
#include <memory>
#include <vector>

class vtkRenderer;

namespace dewpoint::ui {

/// Camera images in the scene, each at the far end of its camera's viewing pyramid, slightly
/// translucent. Lens distortion is not removed, because it is not visible at this size.
class FrustumImages {
public:
  /// Creates the image actors. They are drawn over everything added to `renderer` before.
  explicit FrustumImages(vtkRenderer* renderer);
  ~FrustumImages();
  FrustumImages(const FrustumImages&) = delete;
  FrustumImages& operator=(const FrustumImages&) = delete;

  /// Shows the images in `frames` (null for none) at the viewing pyramids `glyphs`.
  void show(const std::vector<CameraGlyph>& glyphs, const FrameSetPtr& frames);
  void hide();

private:
  struct ImagePlane {
    vtkNew<vtkPolyData> quad;
    vtkNew<vtkImageData> pixels;
    vtkNew<vtkTexture> texture;
    vtkSmartPointer<vtkActor> actor;
  };
  ImagePlane& plane(std::size_t index);

  vtkRenderer* renderer_;
  std::vector<std::unique_ptr<ImagePlane>> planes_;
};

} // namespace dewpoint::ui
