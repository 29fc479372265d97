// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"
#include "ui/view3d/view_projection.h"

#include <QPointF>

#include <vector>

class QPainter;

namespace dewpoint::ui {

/// The numbers of people, above their heads in a picture of the scene.
class PersonBadges {
public:
  /// Those of the snapshot that the picture shows; null: nobody.
  void setSnapshot(const TrackSnapshot* snapshot);
  /// The person whose badge or body is at a position of the view, as index among the targets; -1:
  /// nobody.
  int personAt(const ViewProjection& projection, QPointF position) const;
  /// The chosen one (index among the targets) stands out.
  void paint(QPainter& painter, const QWidget& view, const ViewProjection& projection,
             int chosen) const;

private:
  struct Badge {
    int identity;
    Eigen::Vector3d place; ///< above the head
  };
  std::vector<Badge> badges_;
};

} // namespace dewpoint::ui
