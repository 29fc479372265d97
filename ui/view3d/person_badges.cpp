// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/person_badges.h"

#include "core/session/snapshot/snapshot_state.h"
#include "ui/style/identity_badge.h"

#include <QPainter>
#include <QWidget>

#include <cmath>

namespace dewpoint::ui {

namespace {
constexpr double kUsualHalf = 0.86; ///< meters, half of a person whose height is not estimated
constexpr double kBesidePx = 9.0;   ///< between the top of a body and its badge
} // namespace

void PersonBadges::setSnapshot(const TrackSnapshot* snapshot) {
  badges_.clear();
  if (snapshot == nullptr) {
    return;
  }
  for (const auto& [index, target, person] : peopleIn(*snapshot)) {
    // Above the head, so that the curves on the floor stay in sight.
    const double half = person->height > 0.0 ? 0.5 * person->height : kUsualHalf;
    badges_.push_back({person->identity, person->position + half * Eigen::Vector3d::UnitZ()});
  }
}

int PersonBadges::personAt(const ViewProjection& projection, QPointF position) const {
  constexpr double kReachPx = 20.0; // of badge and body
  for (const Badge& badge : badges_) {
    const QPointF away = projection.toWidget(badge.position) - QPointF(0.0, kBesidePx) - position;
    if (std::hypot(away.x(), away.y()) < kReachPx) {
      return badge.identity - 1;
    }
  }
  return -1;
}

void PersonBadges::paint(QPainter& painter, const QWidget& view, const ViewProjection& projection,
                         int chosen) const {
  for (const Badge& badge : badges_) {
    paintIdentityBadge(painter, badge.identity,
                       projection.toWidget(badge.position) - QPointF(0.0, kBesidePx),
                       QRectF(view.rect()), badge.identity - 1 == chosen);
  }
}

} // namespace dewpoint::ui
