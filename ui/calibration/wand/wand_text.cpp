// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/wand/wand_text.h"

#include "ui/text/quantity_text.h"

#include <QCoreApplication>

#include <cmath>

namespace dewpoint::ui {
namespace {

class WandText {
  Q_DECLARE_TR_FUNCTIONS(WandSettings)
};

QString moveItThereText(const QString& camera, ImageSide side) {
  switch (side) {
  case ImageSide::Left:
    return WandText::tr("Also move the ball to the left part of the image of %1.").arg(camera);
  case ImageSide::Right:
    return WandText::tr("Also move the ball to the right part of the image of %1.").arg(camera);
  case ImageSide::Top:
    return WandText::tr("Also move the ball to the upper part of the image of %1.").arg(camera);
  case ImageSide::Bottom:
    return WandText::tr("Also move the ball to the lower part of the image of %1.").arg(camera);
  default:
    return WandText::tr("Also move the ball to all edges of the image of %1.").arg(camera);
  }
}

} // namespace

QString wandEventText(WandEvent role) {
  switch (role) {
  case WandEvent::Floor:
    return WandText::tr("The ball touches the floor");
  case WandEvent::DistanceFrom:
    return WandText::tr("The ball is at one end of the known distance");
  case WandEvent::DistanceTo:
    return WandText::tr("The ball is at the other end of the known distance");
  case WandEvent::FallBegins:
    return WandText::tr("First frame of the fall");
  case WandEvent::FallEnds:
    break;
  }
  return WandText::tr("Last frame of the fall");
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
    return WandText::tr("To use a fall, add two times: the first and the last frame of the fall.");
  }
  return {};
}

QString motionGapMessage(const MotionGap& gap, const QStringList& cameraNames) {
  const auto name = [&](std::size_t k) {
    return k < gap.cameras.size() ? cameraNames.value(static_cast<qsizetype>(gap.cameras[k]))
                                  : QString();
  };
  const auto centimeters = [&] {
    return lengthText(gap.motionAmount, LengthScale::Centimeters, 0);
  };
  switch (gap.missingMotion) {
  case MissingMotion::Duration:
    return WandText::tr("The ball was seen for only %1. Wave for half a minute.")
        .arg(secondsText(gap.motionAmount, 0));
  case MissingMotion::OffTheLine:
    return WandText::tr("The ball moved only along one line. Move it in all directions: to the "
                        "sides, up and down, near and far.");
  case MissingMotion::OffThePlane:
    return WandText::tr("The ball moved only within a plane (%1 thick). Also move it across this "
                        "plane: toward %2 and away from it.")
        .arg(centimeters(), name(0));
  case MissingMotion::InDepth:
    return WandText::tr("The distance from %1 to the ball hardly changed (by only %2). Also move "
                        "the ball toward %1 and away from it.")
        .arg(name(0), centimeters());
  case MissingMotion::WholeVolume:
    return WandText::tr("The ball stayed in %1 of the volume that the cameras see together. Move "
                        "it through the whole volume in which you will track.")
        .arg(percentText(gap.motionAmount));
  case MissingMotion::WholeImage:
    return WandText::tr("%1 saw the ball in only %2 of its image.")
               .arg(name(0), percentText(gap.motionAmount)) +
           QLatin1Char(' ') + moveItThereText(name(0), gap.side);
  default:
    return WandText::tr("%1 and %2 saw the ball at the same time in only %n frame(s). Move the "
                        "ball where both cameras see it.",
                        nullptr, static_cast<int>(std::lround(gap.motionAmount)))
        .arg(name(0), name(1));
  }
}

QString lessAccurateResultMessage(const WandRefinement& refinement) {
  if (!refinement.beforeError) {
    return WandText::tr("The cameras were calibrated before, and the motion in this recording is "
                        "not enough to improve that calibration. Keep the previous calibration.");
  }
  return WandText::tr("The old camera positions are known more accurately (±%1) than the new ones "
                      "(±%2). Keep the old positions.")
      .arg(lengthText(*refinement.beforeError, LengthForm::TwoDigits),
           lengthText(newPositionError(refinement), LengthForm::TwoDigits));
}

} // namespace dewpoint::ui
