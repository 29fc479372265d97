// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/guide/guide_text.h"

#include "ui/text/quantity_text.h"

#include <QCoreApplication>

#include <array>

namespace dewpoint::ui {
namespace {

class GuideText {
  Q_DECLARE_TR_FUNCTIONS(GuideText)
};

/// The texts of setup::originText(), for the translators.
[[maybe_unused]] constexpr std::array kOriginTexts{
    QT_TRANSLATE_NOOP("GuideText", "guessed"),
    QT_TRANSLATE_NOOP("GuideText", "exact (simulated)"),
    QT_TRANSLATE_NOOP("GuideText", "set by hand"),
    QT_TRANSLATE_NOOP("GuideText", "measured points"),
    QT_TRANSLATE_NOOP("GuideText", "board"),
    QT_TRANSLATE_NOOP("GuideText", "wand"),
    QT_TRANSLATE_NOOP("GuideText", "from a file"),
    QT_TRANSLATE_NOOP("GuideText", "points marked in the images")};

/// Where numbers come from, or how they are otherwise known.
QString statusOriginName(const ItemStatus& part) {
  return GuideText::tr(originText(part));
}

QString withError(const ItemStatus& part, const QString& error) {
  const QString origin = statusOriginName(part);
  return error.isEmpty() ? origin
         : part.isPoor   ? GuideText::tr("%1, ±%2: too inaccurate").arg(origin, error)
                         : GuideText::tr("%1, ±%2").arg(origin, error);
}

QString deviationText(StepErrorUnit unit, std::optional<double> error) {
  if (!error) {
    return {};
  }
  switch (unit) {
  case StepErrorUnit::Pixels:
    return pixelText(*error);
  case StepErrorUnit::Meters:
    return lengthText(*error, LengthForm::TwoDigits);
  case StepErrorUnit::Fraction:
    return percentAccuracyText(*error) + QStringLiteral(" %");
  case StepErrorUnit::None:
    break;
  }
  return {};
}

bool countsCameras(GuideStep step) {
  return step != GuideStep::PrintBoard && step != GuideStep::LearnBall &&
         step != GuideStep::Floor && step != GuideStep::MeasuredLength;
}

} // namespace

ProcedureText procedureText(CalibrationProcedure procedure) {
  switch (procedure) {
  case CalibrationProcedure::Grid:
    return {GuideText::tr("By hand: fit a drawn grid to the images"),
            GuideText::tr("You need one known length, such as the length of a table or of a floor "
                          "tile. You get a first result within minutes.")};
  case CalibrationProcedure::Points:
    return {GuideText::tr("Measured points"),
            GuideText::tr(
                "You need a tape measure and points that the cameras see: at least four for each "
                "camera, better six. Choose this for cameras that are mounted in a room.")};
  case CalibrationProcedure::Board:
    return {GuideText::tr("Printed board"),
            GuideText::tr("You need a printed board that you can carry through the room. This is "
                          "the most accurate way to calibrate the lenses.")};
  case CalibrationProcedure::Wand:
    return {GuideText::tr("Wand: a ball, or a stick with two balls"),
            GuideText::tr("You need rough camera positions and a ball to wave. This is the most "
                          "accurate way to find the camera positions in a large room.")};
  case CalibrationProcedure::File:
    break;
  }
  return {
      GuideText::tr("File of another program"),
      GuideText::tr("You need a calibration file for these cameras and for images of this size.")};
}

StepText stepText(GuideStep step) {
  switch (step) {
  case GuideStep::ImportFile:
    return {GuideText::tr("File"), GuideText::tr("Import the file"),
            GuideText::tr(
                "Choose the file. If something is missing in the file, such as the unit, the "
                "dialog asks you for it. The dialog also shows how far each camera would move."),
            GuideText::tr("Import calibration…")};
  case GuideStep::PrintBoard:
    return {
        GuideText::tr("Print"), GuideText::tr("Print a board"),
        GuideText::tr("Describe the board on the page Board, and print it at 100 %. Check the "
                      "scale bar with a ruler, and glue the sheet to something stiff and flat. If "
                      "you already have a board, just describe it and go on to the next step."),
        GuideText::tr("Go to the page Board")};
  case GuideStep::LensesByBoard:
    return {
        GuideText::tr("Lenses"), GuideText::tr("Calibrate the lenses"),
        GuideText::tr(
            "On the page Board, choose Intrinsics. With live cameras, press Start and show the "
            "board to each camera: close, tilted to all sides, and in the corners of the image. "
            "Hold it still each time. If you have already recorded this, just press Calibrate."),
        GuideText::tr("Go to the page Board")};
  case GuideStep::FieldOfView:
    return {GuideText::tr("Lenses"), GuideText::tr("Set the field of view"),
            GuideText::tr("Enter the field of view or the focal length of each camera, for example "
                          "from its data sheet. Calibrating the lens with a board is more "
                          "accurate, but you do not need it to begin."),
            GuideText::tr("Go to the page By hand")};
  case GuideStep::GridOnFloor:
    return {GuideText::tr("Grid"), GuideText::tr("Lay the grid over the room"),
            GuideText::tr("Give the grid the size of a real object that you have measured. In each "
                          "image, drag the grid until it lies on this object. Click a point of the "
                          "grid to hold it in place."),
            GuideText::tr("Go to the page By hand")};
  case GuideStep::MeasurePoints:
    return {GuideText::tr("Points"), GuideText::tr("Measure points and click them"),
            GuideText::tr("Add points whose positions in the room you have measured, in meters. "
                          "Then click each point in the images. Each camera needs at least four "
                          "points, or better six that do not all lie in one plane."),
            GuideText::tr("Go to the page By hand")};
  case GuideStep::ComputeCameras:
    return {GuideText::tr("Positions"), GuideText::tr("Compute the cameras"),
            GuideText::tr("Press Compute cameras below the table of points. If a point fits badly, "
                          "the page tells you which one."),
            GuideText::tr("Go to the page By hand")};
  case GuideStep::BoardInVolume:
    return {GuideText::tr("Positions"), GuideText::tr("Find the camera positions"),
            GuideText::tr(
                "On the page Board, choose Camera positions. With live cameras, press Start and "
                "show the board to at least two cameras at a time, in many parts of the volume. "
                "Lay it on the floor once, and press Set floor from board. If you have already "
                "recorded this, enter the frame with the board on the floor and press Calibrate."),
            GuideText::tr("Go to the page Board")};
  case GuideStep::RoughPositions:
    return {GuideText::tr("Rough"), GuideText::tr("Place the cameras roughly"),
            GuideText::tr("Drag the grid in each image, or the cameras in the bird's-eye view, "
                          "until each camera is within about 12 cm of its real position."),
            GuideText::tr("Go to the page By hand")};
  case GuideStep::LearnBall:
    return {GuideText::tr("Ball"), GuideText::tr("Learn the color of the ball"),
            GuideText::tr("Click the ball in an image. For a stick with two balls, learn two "
                          "targets of different colors."),
            GuideText::tr("Learn color")};
  case GuideStep::WaveWand:
    return {GuideText::tr("Wave"), GuideText::tr("Wave the wand"),
            GuideText::tr("On the page Wand, choose what you wave and where the scale comes from. "
                          "With live cameras, press Start waving and wave slowly through the whole "
                          "volume for half a minute. Then press Refine cameras. If you have "
                          "already recorded this, just press Refine cameras."),
            GuideText::tr("Go to the page Wand")};
  case GuideStep::Floor:
    return {
        GuideText::tr("Floor"), GuideText::tr("Set floor and origin"),
        GuideText::tr(
            "Mark three points of the floor as A, B and C, each in at least two images. A becomes "
            "the origin, and the x axis points from A to B. Then press Set floor from A, B and C."),
        GuideText::tr("Go to the page Floor")};
  case GuideStep::MeasuredLength:
    break;
  }
  return {GuideText::tr("Length"), GuideText::tr("Check a measured length"),
          GuideText::tr("Measure a distance in the room, as long as possible. Mark its ends as A "
                        "and B, enter the distance, and press Check. If the calibration gives a "
                        "different distance, press Set scale to correct the calibration."),
          GuideText::tr("Go to the page Floor")};
}

QString progressText(GuideStep step, const StepProgress& progress) {
  const QString error = deviationText(errorUnit(step), progress.error);
  if (!countsCameras(step)) {
    if (!progress.isDone()) {
      return GuideText::tr("Not done yet.");
    }
    return error.isEmpty()
               ? GuideText::tr("Done.")
               : GuideText::tr(
                     "Done: the distance in the calibration differs from the measured one by %1.")
                     .arg(error);
  }
  return error.isEmpty() ? GuideText::tr("Done for %1 of %2 cameras.")
                               .arg(progress.doneCount)
                               .arg(progress.totalCount)
                         : GuideText::tr("Done for %1 of %2 cameras. The largest error is %3.")
                               .arg(progress.doneCount)
                               .arg(progress.totalCount)
                               .arg(error);
}

QString progressNumberText(GuideStep step, const StepProgress& progress) {
  const QString error = deviationText(errorUnit(step), progress.error);
  if (progress.isDone() && !error.isEmpty()) {
    return error;
  }
  return countsCameras(step)
             ? QStringLiteral("%1/%2").arg(progress.doneCount).arg(progress.totalCount)
             : QString();
}

QString lensText(const ItemStatus& lens) {
  return withError(lens, deviationText(StepErrorUnit::Pixels, lens.error));
}

QString poseText(const ItemStatus& pose) {
  return withError(pose, deviationText(StepErrorUnit::Meters, pose.error));
}

QString scaleText(const ItemStatus& scale) {
  return withError(scale, deviationText(StepErrorUnit::Fraction, scale.error));
}

QString floorText(const ItemStatus& floor, bool isUpright) {
  return isUpright ? statusOriginName(floor)
                   : GuideText::tr("the z axis does not seem to point up");
}

QString statusSymbol(const ItemStatus& part) {
  switch (part.isPoor ? KnowledgeLevel::Missing : part.knowledge) {
  case KnowledgeLevel::Measured:
    return QStringLiteral("✓");
  case KnowledgeLevel::Given:
    return QStringLiteral("○");
  case KnowledgeLevel::Missing:
    break;
  }
  return QStringLiteral("⚠");
}

} // namespace dewpoint::ui
