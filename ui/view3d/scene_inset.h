// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"
#include "ui/view3d/view_projection.h"

#include <QRectF>

#include <utility>

class QPainter;

namespace dewpoint::ui {

/// Inset in a corner of the bird's-eye view that enlarges a particle cloud too small to see, with
/// its 95 % ellipsoid and a scale bar. The inset is at the lower right, or at the upper right if it
/// covers fewer cameras and floor numbers there.
class SceneInset {
public:
  explicit SceneInset(const Scene3d& scene) : scene_(scene) {}

  /// Sets the snapshot shown in the rendered image. May be null.
  void setSnapshot(TrackSnapshotPtr snapshot) { snapshot_ = std::move(snapshot); }
  /// Returns the index of the target to enlarge: the selected target `chosen`, or else the first
  /// target whose cloud is too small to see. Returns -1 if there is none, or if the view has no
  /// room for an inset.
  int targetToEnlarge(const QWidget& view, int chosen) const;
  /// Returns whether the view is large enough for an inset.
  static bool fitsInView(const QWidget& view);
  /// Returns the usual area of the inset, at the lower right, in view pixels.
  static QRectF usualArea(const QWidget& view);
  /// Returns the area where the inset is painted, in view pixels; empty if there is no inset.
  QRectF shownArea(const QWidget& view, int chosen) const;
  void paint(QPainter& painter, const QWidget& view, int chosen) const;

private:
  bool isTooSmall(const TargetSnapshot& target) const;
  /// Returns how many cameras and floor numbers this area covers.
  int coveredCount(const QWidget& view, const QRectF& box) const;

  const Scene3d& scene_;
  TrackSnapshotPtr snapshot_;
};

} // namespace dewpoint::ui
