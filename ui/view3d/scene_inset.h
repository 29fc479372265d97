// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"
#include "ui/view3d/view_projection.h"

#include <QRectF>

#include <utility>

class QPainter;

namespace dewpoint::ui {

/// Inset that enlarges a particle cloud too small to see in the picture, in a corner of the view,
/// with its 95 % ellipsoid and a scale bar.
class SceneInset {
public:
  explicit SceneInset(const Scene3d& scene) : scene_(scene) {}

  /// Sets the snapshot that the picture shows; null: none.
  void setSnapshot(TrackSnapshotPtr snapshot) { snapshot_ = std::move(snapshot); }
  /// Returns the target that is enlarged: the selected one, else the first whose cloud is too small
  /// to see; -1: none, or no room in the view.
  int target(const QWidget& view, int chosen) const;
  /// Area of the inset, view pixels.
  static QRectF place(const QWidget& view);
  void paint(QPainter& painter, const QWidget& view, int chosen) const;

private:
  bool isTooSmall(const TargetSnapshot& target) const;

  const Scene3d& scene_;
  TrackSnapshotPtr snapshot_;
};

} // namespace dewpoint::ui
