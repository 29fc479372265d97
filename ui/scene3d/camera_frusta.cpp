// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/camera_frusta.h"

#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace dewpoint::ui {
namespace {

bool usable(const Camera& camera) {
  return camera.intrinsics.focalX > 0.0 && camera.intrinsics.focalY > 0.0 &&
         camera.intrinsics.width > 0 && camera.intrinsics.height > 0 &&
         camera.cameraFromWorld.matrix().allFinite();
}

/// The world point seen at a pixel, `depth` meters before the camera. Distortion is left out: it
/// would not be visible at this size.
Eigen::Vector3d unproject(const Camera& camera, double column, double row, double depth) {
  const Intrinsics& k = camera.intrinsics;
  const Eigen::Vector3d ray((column - k.centerX) / k.focalX, (row - k.centerY) / k.focalY, 1.0);
  return camera.cameraFromWorld.inverse() * (ray * depth);
}

} // namespace

CameraFrusta::CameraFrusta(vtkRenderer* renderer)
    : edges_(makeFlatActor(edgeData_)), faces_(makeFlatActor(faceData_)),
      plumbs_(makeFlatActor(plumbData_)) {
  renderer->AddActor(edges_);
  renderer->AddActor(faces_);
  renderer->AddActor(plumbs_);
}

void CameraFrusta::show(const CameraRig& rig, double length) {
  glyphs_.clear();
  LinesAndFaces edges;
  LinesAndFaces faces;
  LinesAndFaces plumbs;
  for (std::size_t index = 0; index < rig.size(); ++index) {
    const Camera& camera = rig[index];
    if (!usable(camera)) {
      continue;
    }
    const double right = camera.intrinsics.width - 0.5;
    const double bottom = camera.intrinsics.height - 0.5;
    const std::vector<Eigen::Vector3d> image{
        unproject(camera, -0.5, -0.5, length), unproject(camera, right, -0.5, length),
        unproject(camera, right, bottom, length), unproject(camera, -0.5, bottom, length)};
    const Eigen::Vector3d center = camera.center();
    edges.addPolyline({image[0], image[1], image[2], image[3], image[0]});
    for (const Eigen::Vector3d& corner : image) {
      edges.addLine(center, corner);
    }
    // A roof over the upper edge says which way up the image is.
    const Eigen::Vector3d middle = 0.5 * (image[0] + image[1]);
    const Eigen::Vector3d up = (image[0] - image[3]) * 0.18;
    faces.addFace({mix(middle, image[0], 0.4), middle + up, mix(middle, image[1], 0.4)});
    faces.addFace(image);
    plumbs.addLine(center, {center.x(), center.y(), 0.0});
    glyphs_.push_back({camera.name, center, {image[0], image[1], image[2], image[3]}, index});
  }
  edges.writeTo(edgeData_);
  faces.writeTo(faceData_);
  plumbs.writeTo(plumbData_);
}

void CameraFrusta::setPalette(const ScenePalette& palette) {
  setActorColor(edges_, palette.camera);
  setActorColor(faces_, palette.camera, 0.22);
  setActorColor(plumbs_, palette.camera, 0.3);
}

void CameraFrusta::prepareRendering(const ScreenScale& scale) {
  edges_->GetProperty()->SetLineWidth(static_cast<float>(1.5 * scale.pixelRatio));
  plumbs_->GetProperty()->SetLineWidth(static_cast<float>(scale.pixelRatio));
}

} // namespace dewpoint::ui
