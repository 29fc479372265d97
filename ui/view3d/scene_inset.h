// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"
#include "ui/view3d/view_projection.h"

#include <QRectF>

#include <utility>

class QPainter;

namespace dewpoint::ui {

/// A magnifier for a cloud of particles that is too small to be seen in the picture: enlarged in a
/// corner, with the ellipsoid that holds 95 % of the belief and a bar that says how long it is.
class SceneInset {
public:
  explicit SceneInset(const Scene3d& scene) : scene_(scene) {}

  /// The one that the picture shows; null: none.
  void setSnapshot(TrackSnapshotPtr snapshot) { snapshot_ = std::move(snapshot); }
  /// The target that is enlarged: the chosen one, else the first whose cloud is too small to be
  /// seen; -1: none, as when the view has no room for it.
  int target(const QWidget& view, int chosen) const;
  /// Where it is, view pixels.
  static QRectF place(const QWidget& view);
  void paint(QPainter& painter, const QWidget& view, int chosen) const;

private:
  bool isTooSmall(const TargetSnapshot& target) const;

  const Scene3d& scene_;
  TrackSnapshotPtr snapshot_;
};

} // namespace dewpoint::ui
