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

/// Where lines and texts of constant size on the screen are.
struct ScreenScale {
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();
  Eigen::Vector3d direction = -Eigen::Vector3d::UnitZ(); ///< unit, into the picture
  Eigen::Vector3d right = Eigen::Vector3d::UnitX();
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  bool parallel = true;
  double metersPerPixel = 0.01; ///< at the focus
  double slope = 0.0;           ///< meters per pixel and meter of depth, perspective only
  double pixelRatio = 1.0;

  /// Depth before the eye, meters.
  double depth(const Eigen::Vector3d& point) const { return (point - eye).dot(direction); }
  /// By which factor to shrink something about the eye, so that it comes `distance` meters nearer
  /// and appears as large; in parallel views it is only moved.
  double nearerFactor(const Eigen::Vector3d& point, double distance) const;
  Eigen::Vector3d nearer(const Eigen::Vector3d& point, double distance) const;
  /// Length in meters at `point` of a length in logical pixels.
  double meters(const Eigen::Vector3d& point, double pixels) const;
  /// Where a point is in the picture: device pixels right of and above the center.
  Eigen::Vector2d place(const Eigen::Vector3d& point) const;
  /// The point at a position in the picture that is as deep in it as `like` is.
  Eigen::Vector3d world(const Eigen::Vector2d& place, const Eigen::Vector3d& like) const;
};

/// Adds a new prop, which must not be there yet: AddActor would search all that are, so that the
/// time to add thousands grew with their square.
void addNew(vtkRenderer* renderer, vtkProp* prop);
/// An actor without lighting, of plain lines or faces.
vtkSmartPointer<vtkActor> flatActor(vtkPolyData* data);
/// The same, invisible at first, and added to be blended in its turn.
vtkSmartPointer<vtkActor> addedInTurn(vtkRenderer* renderer, vtkPolyData* data);
void paint(vtkActor* actor, const SceneColor& color, double opacity = 1.0);
/// Red, green and blue, 0 to 255.
std::array<unsigned char, 3> colorBytes(const SceneColor& color);

/// Builds line and face data.
class Strokes {
public:
  Strokes();
  void line(const Eigen::Vector3d& from, const Eigen::Vector3d& to);
  void polyline(const std::vector<Eigen::Vector3d>& points);
  void face(const std::vector<Eigen::Vector3d>& corners);
  /// Replaces the content of `data`.
  void writeTo(vtkPolyData* data) const;

private:
  std::vector<std::vector<Eigen::Vector3d>> lines_;
  std::vector<std::vector<Eigen::Vector3d>> faces_;
};

/// Texts of constant size on the screen, each at a point of the world.
class SceneLabels {
public:
  explicit SceneLabels(vtkRenderer* renderer);
  ~SceneLabels();
  SceneLabels(const SceneLabels&) = delete;
  SceneLabels& operator=(const SceneLabels&) = delete;
  void clear();
  /// `right`, `up`: where beside the point the text stands, in heights of the text.
  void add(const std::string& text, const Eigen::Vector3d& point, double sizePx, double right = 0.0,
           double up = 0.0);
  void setVisible(bool visible) { visible_ = visible; }
  void setColors(const SceneColor& text, const SceneColor& background);
  void prepareFrame(const ScreenScale& scale);
  /// Adds the rectangles that the texts take in the picture, about: device pixels right of and
  /// above the center.
  void appendPlaces(const ScreenScale& scale, std::vector<Eigen::AlignedBox2d>& places) const;

private:
  struct Label {
    vtkSmartPointer<vtkTextActor> actor;
    Eigen::Vector3d point;
    double sizePx;
    double right;
    double up;
  };
  void paintLabel(const Label& label) const;

  vtkRenderer* renderer_;
  std::vector<Label> labels_;
  bool visible_ = true;
  SceneColor text_ = SceneColor::Zero();
  SceneColor background_ = SceneColor::Ones();
};

} // namespace dewpoint::ui
