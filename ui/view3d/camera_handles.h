// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/scene3d.h"

#include <QObject>
#include <QPointF>

#include <optional>
#include <vector>

class QPainter;
class QWidget;

namespace dewpoint::ui {

/// Handle of a draggable camera: the camera's position and a point at which it looks, in world
/// coordinates (meters).
struct CameraHandle {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d target = Eigen::Vector3d::Zero();
};

/// Handles for dragging cameras with the mouse in a rendered image of the scene. The selected
/// camera also has a handle for the point it looks at.
class CameraHandles : public QObject {
  Q_OBJECT
public:
  /// Creates an object without handles. `view` must show the whole rendered image of `scene`.
  CameraHandles(QWidget& view, Scene3d& scene);

  /// Sets the handles, one per camera, and the index of the selected camera. If the list is empty,
  /// no camera can be dragged.
  void setHandles(std::vector<CameraHandle> handles, int chosen);
  /// Starts to drag the handle at a position in the view. Returns false if there is no handle.
  bool grab(QPointF position);
  bool isDragging() const { return drag_.has_value(); }
  void drag(QPointF position);
  void endDrag();
  void paint(QPainter& painter) const;

Q_SIGNALS:
  /// Emitted when the user pressed the handle of a camera.
  void cameraChosen(int camera);
  /// cameraDragged() is emitted while a camera is dragged to this world position (meters),
  /// cameraAimed() while the point at which the camera looks is dragged. In the views from above,
  /// from the front and from the side, the drag stays in the plane of the view; in the 3D view, it
  /// is parallel to the image plane.
  void cameraDragged(int camera, const Eigen::Vector3d& center);
  void cameraAimed(int camera, const Eigen::Vector3d& target);
  void cameraDropped();

private:
  struct Drag {
    int camera;
    bool isAimHandle;
    Eigen::Vector3d startPoint;
    QPointF startPosition;
  };

  QWidget& view_;
  Scene3d& scene_;
  std::vector<CameraHandle> handles_;
  int chosen_ = -1;
  std::optional<Drag> drag_;
};

} // namespace dewpoint::ui
