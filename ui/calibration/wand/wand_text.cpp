// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/wand/wand_text.h"

#include <QCoreApplication>

namespace dewpoint::ui {
namespace {

class WandText {
  Q_DECLARE_TR_FUNCTIONS(WandSettings)
};

} // namespace

QString touchText(WandEvent role) {
  switch (role) {
  case WandEvent::Floor:
    return WandText::tr("touches the floor");
  case WandEvent::DistanceFrom:
    return WandText::tr("is at the first end of the distance");
  case WandEvent::DistanceTo:
    return WandText::tr("is at the second end of the distance");
  case WandEvent::FallBegins:
    return WandText::tr("begins to fall");
  case WandEvent::FallEnds:
    break;
  }
  return WandText::tr("is still falling");
}

QString validationMessage(const WandSettings& settings, const std::vector<MarkedInstant>& instants,
                          const Project& project) {
  switch (obstacleOf(settings, instants, project)) {
  case WandObstacle::None:
    break;
  case WandObstacle::TooFewCameras:
    return WandText::tr("At least two cameras must see the ball.");
  case WandObstacle::NoBall:
    return WandText::tr(
        "Learn the color of the ball first: press “Learn the color” in the toolbar, then click the "
        "ball in an image.");
  case WandObstacle::NoSecondBall:
    return WandText::tr(
        "A wand has two balls of different colors: press “Add a target” in the toolbar, then click "
        "the second ball in an image.");
  case WandObstacle::SameBallTwice:
    return WandText::tr(
        "Both ends of the wand are the same target: choose another target for one of them.");
  case WandObstacle::IncompleteDistance:
    return WandText::tr("The scale comes from a known distance: add the times at which the ball is "
                        "at each end of this distance.");
  case WandObstacle::IncompleteFall:
    return WandText::tr("A fall needs two times: one at which the ball starts to fall, and one at "
                        "which it is still falling.");
  }
  return {};
}

} // namespace dewpoint::ui
