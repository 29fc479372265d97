// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/fading_line.h"

#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>

namespace dewpoint::ui {
namespace {

constexpr double kFaded = 0.85;         ///< of the opacity, at the oldest position
constexpr double kOutlineOpacity = 0.3; ///< quiet: it only parts the line from what is behind

bool isKnown(const Eigen::Vector3d& point) {
  return point.allFinite();
}

/// The colors of the points of a line, one by one.
class Fade {
public:
  Fade(const SceneColor& color, double opacity) : rgb_(colorBytes(color)), opacity_(opacity) {
    colors_->SetNumberOfComponents(4);
  }
  /// `age`: 0 of the newest, towards 1 of the oldest.
  void add(double age) {
    const std::array<unsigned char, 4> rgba{
        rgb_[0], rgb_[1], rgb_[2],
        static_cast<unsigned char>(255.0 * opacity_ * (1.0 - kFaded * age))};
    colors_->InsertNextTypedTuple(rgba.data());
  }
  bool any() const { return colors_->GetNumberOfTuples() > 0; }
  void writeTo(vtkPolyData* data) const {
    data->GetPointData()->SetScalars(any() ? colors_.Get() : nullptr);
  }

private:
  std::array<unsigned char, 3> rgb_;
  double opacity_;
  vtkNew<vtkUnsignedCharArray> colors_;
};

} // namespace

FadingLine::FadingLine(vtkRenderer* renderer, double widthPx, double outlinePx)
    : renderer_(renderer), widthPx_(widthPx), outlinePx_(outlinePx),
      outline_(addNewActor(renderer, outlineData_)), line_(addNewActor(renderer, data_)) {}

FadingLine::~FadingLine() {
  renderer_->RemoveActor(outline_);
  renderer_->RemoveActor(line_);
}

void FadingLine::show(const std::vector<Eigen::Vector3d>& points) {
  points_ = points;
  draw();
}

void FadingLine::setColors(const SceneColor& line, const SceneColor& outline) {
  if (line != color_ || outline != outlineColor_) {
    color_ = line;
    outlineColor_ = outline;
    draw();
  }
}

void FadingLine::draw() {
  LinesAndFaces strokes;
  Fade fade(color_, 1.0);
  Fade outlineFade(outlineColor_, kOutlineOpacity);
  for (auto begin = points_.begin(); begin != points_.end();) {
    const auto end = std::find_if_not(begin, points_.end(), isKnown);
    if (end - begin > 1) {
      strokes.addPolyline({begin, end});
      for (auto point = begin; point != end; ++point) {
        const double age =
            static_cast<double>(points_.end() - point - 1) / static_cast<double>(points_.size());
        fade.add(age);
        outlineFade.add(age);
      }
    }
    begin = std::find_if(end, points_.end(), isKnown);
  }
  strokes.writeTo(data_);
  fade.writeTo(data_);
  outlineData_->ShallowCopy(data_);
  outlineFade.writeTo(outlineData_);
  line_->SetVisibility(fade.any());
  outline_->SetVisibility(fade.any() && outlinePx_ > 0.0);
}

void FadingLine::prepareRendering(const ScreenScale& scale) {
  line_->GetProperty()->SetLineWidth(static_cast<float>(widthPx_ * scale.pixelRatio));
  outline_->GetProperty()->SetLineWidth(
      static_cast<float>((widthPx_ + 2.0 * outlinePx_) * scale.pixelRatio));
}

} // namespace dewpoint::ui
