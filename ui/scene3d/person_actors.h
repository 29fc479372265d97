// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/people/person_shape.h"
#include "ui/scene3d/scene_actors.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <iterator>

class vtkRenderer;

namespace dewpoint::ui {

/// Body of a person: the translucent hull of the 95 % volume and, on the floor, the level curves of
/// the density (Mohedano et al. 2009, figures 1 and 2c).
class PersonActors {
public:
  explicit PersonActors(vtkRenderer* renderer);
  ~PersonActors();
  PersonActors(const PersonActors&) = delete;
  PersonActors& operator=(const PersonActors&) = delete;

  /// Shows the body of a person, or hides it if `shape` is null.
  void show(const PersonShape* shape);
  void setChosen(bool chosen);
  void setColor(const SceneColor& color, const ScenePalette& palette);
  void prepareRendering(const ScreenScale& scale);

private:
  void repaint();

  vtkRenderer* renderer_;
  SceneColor color_ = SceneColor::Zero();
  ScenePalette palette_;
  bool chosen_ = false;
  vtkNew<vtkPolyData> hullData_;
  vtkNew<vtkPolyData> edgeData_;
  std::array<vtkNew<vtkPolyData>, std::size(kGroundProbabilities)> curveData_;
  vtkSmartPointer<vtkActor> hull_;
  vtkSmartPointer<vtkActor> edges_;
  std::array<vtkSmartPointer<vtkActor>, std::size(kGroundProbabilities)> curves_;
};

} // namespace dewpoint::ui
