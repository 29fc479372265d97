// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/view3d/view_projection.h"

#include <QCoreApplication>
#include <QPointF>
#include <QString>

#include <memory>

class QPainter;

namespace dewpoint::ui {

/// Map of expected errors in the bird's-eye view: the map in the scene, the legend over the
/// rendered image, and values as text.
class MapOverlay {
  Q_DECLARE_TR_FUNCTIONS(MapOverlay)
public:
  explicit MapOverlay(Scene3d& scene) : scene_(scene) {}

  /// Sets the map, or removes it if `map` is null. Returns false if nothing changes.
  bool setMap(std::shared_ptr<const RigMap> map, const MapOptions& look);
  const RigMap* map() const { return map_.get(); }
  std::shared_ptr<const RigMap> sharedMap() const { return map_; }
  const MapOptions& options() const { return options_; }
  /// Shows the newest map in the scene. Call this before rendering, so that only the last of
  /// several maps is drawn.
  void updateScene();
  /// Returns the map value at a position in the view as text; empty outside the map.
  QString textAt(const ViewProjection& projection, QPointF position) const;
  void paintLegend(QPainter& painter, const QWidget& view) const;

private:
  Scene3d& scene_;
  std::shared_ptr<const RigMap> map_;
  MapOptions options_;
  bool stale_ = false;
};

} // namespace dewpoint::ui
