// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/view3d/view_projection.h"

#include <QCoreApplication>
#include <QPointF>
#include <QString>

#include <memory>

class QPainter;

namespace dewpoint::ui {

/// How well the cameras see the room: a map in the scene, its legend over the picture, and its
/// values in words.
class MapOverlay {
  Q_DECLARE_TR_FUNCTIONS(MapOverlay)
public:
  explicit MapOverlay(Scene3d& scene) : scene_(scene) {}

  /// Null: nothing is shown. False when nothing changes.
  bool set(std::shared_ptr<const RigMap> map, const MapLook& look);
  const RigMap* map() const { return map_.get(); }
  const MapLook& look() const { return look_; }
  /// Brings the scene up to date, however many maps have come since.
  void updateScene();
  /// The value at a position of the picture; empty beside the map.
  QString textAt(const ViewProjection& projection, QPointF position) const;
  void paintLegend(QPainter& painter, const QWidget& view) const;

private:
  Scene3d& scene_;
  std::shared_ptr<const RigMap> map_;
  MapLook look_;
  bool stale_ = false;
};

} // namespace dewpoint::ui
