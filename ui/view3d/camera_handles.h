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

/// Handle of a camera that can be dragged: its position and a point it looks at, world coordinates
/// in meters.
struct CameraHandle {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d target = Eigen::Vector3d::Zero();
};

/// Handles to drag cameras with the mouse in a picture of the scene; the selected camera also has a
/// handle for the point it looks at.
class CameraHandles : public QObject {
  Q_OBJECT
public:
  /// `view` must show the whole picture of `scene`.
  CameraHandles(QWidget& view, Scene3d& scene);

  /// Sets the handles; empty: no camera can be dragged.
  void set(std::vector<CameraHandle> handles, int chosen);
  /// Starts dragging the handle at a position of the view; returns false if there is none.
  bool take(QPointF position);
  bool isHeld() const { return held_.has_value(); }
  void drag(QPointF position);
  void drop();
  void paint(QPainter& painter) const;

Q_SIGNALS:
  /// A handle was pressed.
  void chosen(int camera);
  /// A camera, or the point it looks at, is dragged to this world position (meters): in the plane
  /// of a flat view, otherwise parallel to the picture.
  void dragged(int camera, const Eigen::Vector3d& center);
  void aimed(int camera, const Eigen::Vector3d& target);
  void dropped();

private:
  struct Held {
    int camera;
    bool isTarget;
    Eigen::Vector3d start;
    QPointF from;
  };

  QWidget& view_;
  Scene3d& scene_;
  std::vector<CameraHandle> handles_;
  int chosen_ = -1;
  std::optional<Held> held_;
};

} // namespace dewpoint::ui
