// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/planning/rig_map.h"
#include "ui/scene3d/map_look.h"
#include "ui/scene3d/scene_actors.h"

#include <Eigen/Geometry>
#include <vtkPolyData.h>

#include <array>
#include <memory>

class vtkImageData;

namespace dewpoint::ui {

/// Map of a rig's accuracy in the room: the box around its volume, a layer of colored cells, and
/// surfaces around the parts with good accuracy and around all parts that can be measured.
class MapActor {
public:
  explicit MapActor(vtkRenderer* renderer);
  ~MapActor();
  MapActor(const MapActor&) = delete;
  MapActor& operator=(const MapActor&) = delete;

  /// Shows a map, or hides it if `map` is null.
  void show(std::shared_ptr<const RigMap> map, const MapOptions& look);
  const MapOptions& options() const { return options_; }
  /// Returns the volume of the map in meters; empty without a map.
  Eigen::AlignedBox3d volume() const;
  void setPalette(const ScenePalette& palette);
  void prepareRendering(const ScreenScale& scale);

private:
  /// Surface between two classes. It is kept because creating an actor is more expensive than
  /// replacing its data.
  struct Surface {
    vtkNew<vtkPolyData> data;
    vtkSmartPointer<vtkActor> actor;
  };
  static constexpr std::size_t kMaxSurfaces = 3;
  void drawBox();
  void drawSlice();
  void drawSurfaces();
  void fill(vtkImageData& image) const;
  double valueAt(std::size_t cell) const;

  vtkRenderer* renderer_;
  vtkNew<vtkPolyData> boxData_;
  vtkNew<vtkPolyData> sliceData_;
  vtkSmartPointer<vtkActor> box_;
  vtkSmartPointer<vtkActor> slice_;
  std::array<Surface, kMaxSurfaces> surfaces_;
  std::shared_ptr<const RigMap> map_;
  MapOptions options_;
};

} // namespace dewpoint::ui
