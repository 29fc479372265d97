// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/scene_palette.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

class vtkPolyData;
class vtkRenderer;

namespace dewpoint::ui {

/// Projection of the current view, used to keep lines and texts at a constant size on the screen.
struct ScreenScale {
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = -Eigen::Vector3d::UnitZ(); ///< unit vector of the viewing direction
  Eigen::Vector3d right = Eigen::Vector3d::UnitX();
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  bool isParallel = true;
  double metersPerPixel = 0.01; ///< meters per device pixel at the point that the view looks at
  double metersPerPixelAndDepth =
      0.0; ///< meters per pixel and per meter of depth; only for perspective
  double pixelRatio = 1.0;

  /// Returns the depth of a point in front of the viewer, in meters.
  double depth(const Eigen::Vector3d& point) const { return (point - eye).dot(direction); }
  /// Returns the factor by which to scale an object about the viewer so that it is `distance`
  /// meters closer and has the same apparent size. In parallel views, the factor is 1, because the
  /// object is only moved.
  double scaleToMoveCloser(const Eigen::Vector3d& point, double distance) const;
  Eigen::Vector3d movedCloser(const Eigen::Vector3d& point, double distance) const;
  /// Converts a length in logical pixels at `point` to meters.
  double lengthInMeters(const Eigen::Vector3d& point, double pixels) const;
  /// Returns the position of a point in the rendered image: device pixels to the right of and above
  /// the center.
  Eigen::Vector2d project(const Eigen::Vector3d& point) const;
  /// Returns the world point at `place` in the rendered image (device pixels to the right of and
  /// above the center), at the same depth as the world point `like`.
  Eigen::Vector3d unproject(const Eigen::Vector2d& place, const Eigen::Vector3d& like) const;
};

/// Adds a prop to the renderer; the prop must not have been added before. This is faster than
/// AddActor, which searches all existing props first.
void addNewProp(vtkRenderer* renderer, vtkProp* prop);
/// Creates an unlit actor for lines or faces.
vtkSmartPointer<vtkActor> makeFlatActor(vtkPolyData* data);
/// Creates an unlit actor for lines or faces, initially hidden, and adds it to the renderer. Actors
/// are blended in the order in which they are added.
vtkSmartPointer<vtkActor> addNewActor(vtkRenderer* renderer, vtkPolyData* data);
/// Sets an actor's color and opacity (0 to 1).
void setActorColor(vtkActor* actor, const SceneColor& color, double opacity = 1.0);
/// Returns a color as red, green and blue, 0 to 255.
std::array<unsigned char, 3> colorBytes(const SceneColor& color);

/// Collects lines and faces, and writes them to VTK poly data.
class LinesAndFaces {
public:
  LinesAndFaces();
  void addLine(const Eigen::Vector3d& from, const Eigen::Vector3d& to);
  void addPolyline(const std::vector<Eigen::Vector3d>& points);
  void addFace(const std::vector<Eigen::Vector3d>& corners);
  /// Replaces the content of `data` by the collected lines and faces.
  void writeTo(vtkPolyData* data) const;

private:
  std::vector<std::vector<Eigen::Vector3d>> lines_;
  std::vector<std::vector<Eigen::Vector3d>> faces_;
};

/// Texts of constant size on the screen, each anchored at a world point.
class SceneLabels {
public:
  explicit SceneLabels(vtkRenderer* renderer);
  ~SceneLabels();
  SceneLabels(const SceneLabels&) = delete;
  SceneLabels& operator=(const SceneLabels&) = delete;
  void clear();
  /// Adds a text at a world point. `right` and `up` are the offset of the text from the point, in
  /// text heights; `sizePx` is the text size in logical pixels.
  void add(const std::string& text, const Eigen::Vector3d& point, double sizePx, double right = 0.0,
           double up = 0.0);
  void setVisible(bool visible) { visible_ = visible; }
  void setColors(const SceneColor& text, const SceneColor& background);
  void prepareRendering(const ScreenScale& scale);
  /// Appends the approximate areas of the texts in the rendered image: device pixels to the right
  /// of and above the center.
  void appendTextAreas(const ScreenScale& scale, std::vector<Eigen::AlignedBox2d>& places) const;

private:
  struct Label {
    vtkSmartPointer<vtkTextActor> actor;
    Eigen::Vector3d point;
    double sizePx;
    double rightOffsetInTextHeights; ///< in text heights, as `upOffsetInTextHeights`
    double upOffsetInTextHeights;
  };
  void paintLabel(const Label& label) const;

  vtkRenderer* renderer_;
  std::vector<Label> labels_;
  bool visible_ = true;
  SceneColor text_ = SceneColor::Zero();
  SceneColor background_ = SceneColor::Ones();
};

} // namespace dewpoint::ui
