// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/frustum_images.h"

#include "ui/scene3d/scene_actors.h"

#include <opencv2/imgproc.hpp>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>
#include <utility>

namespace dewpoint::ui {
namespace {

/// Pixels: at the size of a pyramid more would not be seen, and each takes time to be drawn.
constexpr int kTextureWidth = 320;
constexpr double kImageOpacity = 0.85; ///< what is behind is still guessed at

/// The corners of an image, given around from its upper left, with texture coordinates. Rows of
/// `pixels` run downward, so that the upper left has (0, 0).
void layOut(const std::array<Eigen::Vector3d, 4>& corners, vtkPolyData* quad) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  coordinates->SetName("texture");
  constexpr std::array<std::array<float, 2>, 4> kPlaces{
      {{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}}};
  for (std::size_t k = 0; k < corners.size(); ++k) {
    points->InsertNextPoint(corners[k].data());
    coordinates->InsertNextTuple(kPlaces[k].data());
  }
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({0, 1, 2, 3});
  quad->SetPoints(points);
  quad->SetPolys(cells);
  quad->GetPointData()->SetTCoords(coordinates);
}

/// `image`: CV_8UC3 as the cameras send it, blue first.
void copyPixels(const cv::Mat& image, vtkImageData* pixels) {
  cv::Mat small = image;
  if (image.cols > kTextureWidth) {
    const int height = std::max(1, image.rows * kTextureWidth / image.cols);
    cv::resize(image, small, {kTextureWidth, height}, 0.0, 0.0, cv::INTER_AREA);
  }
  pixels->SetDimensions(small.cols, small.rows, 1);
  pixels->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  cv::Mat target(small.rows, small.cols, CV_8UC3, pixels->GetScalarPointer());
  cv::cvtColor(small, target, cv::COLOR_BGR2RGB);
  pixels->Modified();
}

} // namespace

FrustumImages::FrustumImages(vtkRenderer* renderer) : renderer_(renderer) {}

FrustumImages::~FrustumImages() {
  for (const auto& plane : planes_) {
    renderer_->RemoveActor(plane->actor);
  }
}

FrustumImages::ImagePlane& FrustumImages::plane(std::size_t index) {
  while (planes_.size() <= index) {
    auto made = std::make_unique<ImagePlane>();
    made->texture->SetInputData(made->pixels);
    made->texture->InterpolateOn();
    made->actor = addNewActor(renderer_, made->quad);
    made->actor->SetTexture(made->texture);
    made->actor->GetProperty()->SetOpacity(kImageOpacity);
    planes_.push_back(std::move(made));
  }
  return *planes_[index];
}

void FrustumImages::show(const std::vector<CameraGlyph>& glyphs, const FrameSetPtr& frames) {
  hide();
  for (std::size_t k = 0; frames != nullptr && k < glyphs.size(); ++k) {
    const FramePtr frame =
        glyphs[k].camera < frames->frames.size() ? frames->frames[glyphs[k].camera] : FramePtr();
    if (frame == nullptr || frame->image.type() != CV_8UC3 || frame->image.empty()) {
      continue;
    }
    ImagePlane& shown = plane(k);
    layOut(glyphs[k].corners, shown.quad);
    copyPixels(frame->image, shown.pixels);
    shown.actor->VisibilityOn();
  }
}

void FrustumImages::hide() {
  for (const auto& plane : planes_) {
    plane->actor->VisibilityOff();
  }
}

} // namespace dewpoint::ui
