// SPDX-License-Identifier: GPL-3.0-or-later
// People in the bird's-eye view: their numbers, and where somebody is said to stand.
#include "core/session/people/people_overlay.h"
#include "ui/style/identity_badge.h"
#include "ui/view3d/birds_eye_view.h"

#include <QPainter>

#include <cmath>

namespace dewpoint::ui {

namespace {
constexpr double kUsualHalf = 0.86; ///< metres, half of a person whose height is not estimated
constexpr double kBesidePx = 9.0;   ///< between the top of a body and its badge
} // namespace

void BirdsEyeView::setChosenTarget(int target) {
  chosenTarget_ = target;
  scene_.choose(target);
  requestPicture();
}

void BirdsEyeView::setPlacing(bool placing, double floor) {
  placing_ = placing;
  floor_ = floor;
  if (placing && scene_.view() == Scene3d::View::Front) {
    lookFromAbove(); // edge on, the floor has no places
  }
  setCursor(placing ? Qt::CrossCursor : Qt::ArrowCursor);
}

Eigen::Vector2d BirdsEyeView::inPicture(QPointF position) const {
  const QPointF middle(width() / 2.0, height() / 2.0);
  const QPointF offset = (position - middle) * devicePixelRatioF();
  return {offset.x(), -offset.y()};
}

void BirdsEyeView::clickFloor(QPointF position) {
  if (!hasPicture()) {
    return;
  }
  if (const auto place = scene_.placeAtHeight(inPicture(position), floor_)) {
    Q_EMIT placeClicked(place->head<2>());
  }
}

bool BirdsEyeView::clickPerson(QPointF position) {
  constexpr double kReachPx = 20.0; // of badge and body
  for (const PersonMark& person : people_) {
    const QPointF away = inWidget(person.place) - QPointF(0.0, kBesidePx) - position;
    if (std::hypot(away.x(), away.y()) < kReachPx) {
      Q_EMIT personClicked(person.identity - 1);
      return true;
    }
  }
  return false;
}

void BirdsEyeView::markPeople() {
  people_.clear();
  for (std::size_t k = 0; snapshot_ && k < snapshot_->targets.size(); ++k) {
    const TargetSnapshot& target = snapshot_->targets[k];
    if (const PersonEstimate* person = target.person()) {
      // Above the head, so that the curves on the floor stay in sight.
      const double half = person->height > 0.0 ? 0.5 * person->height : kUsualHalf;
      people_.push_back({person->identity, person->position + half * Eigen::Vector3d::UnitZ()});
    }
  }
}

void BirdsEyeView::paintPeople(QPainter& painter) const {
  for (const PersonMark& person : people_) {
    paintBadge(painter, person.identity, inWidget(person.place) - QPointF(0.0, kBesidePx),
               QRectF(rect()), person.identity - 1 == chosenTarget_);
  }
}

} // namespace dewpoint::ui
