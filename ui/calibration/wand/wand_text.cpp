// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/wand/wand_text.h"

#include <QCoreApplication>

namespace dewpoint::ui {
namespace {

class WandText {
  Q_DECLARE_TR_FUNCTIONS(WandSettings)
};

} // namespace

QString touchText(TouchRole role) {
  switch (role) {
  case TouchRole::Floor:
    return WandText::tr("touches the floor");
  case TouchRole::DistanceFrom:
    return WandText::tr("is at the first end of the distance");
  case TouchRole::DistanceTo:
    return WandText::tr("is at the second end of the distance");
  case TouchRole::FallBegins:
    return WandText::tr("begins to fall");
  case TouchRole::FallEnds:
    break;
  }
  return WandText::tr("still falls");
}

QString validationMessage(const WandSettings& settings, const std::vector<TouchedInstant>& instants,
                          const Project& project) {
  switch (obstacleOf(settings, instants, project)) {
  case WandObstacle::None:
    break;
  case WandObstacle::TooFewCameras:
    return WandText::tr("Two cameras or more must see the ball.");
  case WandObstacle::NoBall:
    return WandText::tr("Learn the color of the ball first: press L and click it in an image.");
  case WandObstacle::NoSecondBall:
    return WandText::tr(
        "A stick has two balls of different colors: learn the second one (Shift+L).");
  case WandObstacle::SameBallTwice:
    return WandText::tr("The two ends of the stick are the same target: choose another.");
  case WandObstacle::DistanceNotTaken:
    return WandText::tr(
        "The size is to come from a distance: take the moments at which the ball is "
        "at its two ends.");
  case WandObstacle::HalfAFall:
    return WandText::tr(
        "A fall needs two moments: one at which the ball begins to fall, and one at "
        "which it still falls.");
  }
  return {};
}

} // namespace dewpoint::ui
