// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"
#include "ui/view3d/view_projection.h"

#include <QPointF>

#include <vector>

class QPainter;

namespace dewpoint::ui {

/// Numbered badges for people, above their heads in a rendered image of the scene.
class PersonBadges {
public:
  /// Sets the snapshot for whose people badges are drawn. If it is null, there are no badges.
  void setSnapshot(const TrackSnapshot* snapshot);
  /// Returns the person whose badge or body is at a position in the view, as an index among the
  /// targets, or -1 if there is none.
  int personAt(const ViewProjection& projection, QPointF position) const;
  /// Draws the badges. The selected person (`chosen`, an index among the targets) is highlighted.
  void paint(QPainter& painter, const QWidget& view, const ViewProjection& projection,
             int chosen) const;

private:
  struct Badge {
    int identity;
    Eigen::Vector3d position; ///< above the head, world coordinates in meters
  };
  std::vector<Badge> badges_;
};

} // namespace dewpoint::ui
