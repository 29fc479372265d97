// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/calibration_text.h"

#include "core/setup/calibration/board_outcome.h"
#include "core/setup/calibration/wand_refinement.h"
#include "ui/text/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <optional>

namespace dewpoint::ui {
namespace {

class CalibrationText {
  Q_DECLARE_TR_FUNCTIONS(CalibrationText)
};

QString cameraFault(const DetectedFault& fault, const QString& first, const QString& second) {
  switch (fault.fault) {
  case CalibrationFault::CamerasSwapped:
    return CalibrationText::tr(
               "Everything fits when %1 and %2 are exchanged: their videos are probably "
               "swapped. Exchange the two files.")
        .arg(first, second);
  case CalibrationFault::CameraDelayed:
    return (fault.value > 0.0
                ? CalibrationText::tr(
                      "%1 agrees with the other cameras only if its video is shifted in time: the "
                      "video is probably %2 frames late. Synchronize the videos, or calibrate with "
                      "a wand and turn on “Find delays”.")
                : CalibrationText::tr(
                      "%1 agrees with the other cameras only if its video is shifted in time: the "
                      "video is probably %2 frames early. Synchronize the videos, or calibrate "
                      "with a wand and turn on “Find delays”."))
        .arg(first, numberText(std::abs(fault.value), 0));
  case CalibrationFault::CameraMoved:
    return CalibrationText::tr(
               "The images of %1 fit one pose before %2 and another pose after that time: the "
               "camera was probably moved. Calibrate with the later part of the recording only.")
        .arg(first, secondsText(fault.value, 1));
  case CalibrationFault::VideoFlipped:
    return CalibrationText::tr(
               "The images of %1 fit only if they are flipped: the video is probably mirrored or "
               "upside down. Set the rotation and mirroring of these images.")
        .arg(first);
  case CalibrationFault::ZoomChanged:
    return CalibrationText::
        tr("The images of %1 fit a focal length that is %2 times the one in its calibration: the "
           "zoom or crop of the camera was probably changed. Calibrate its intrinsics again.")
            .arg(first, ratioText(fault.value));
  default:
    return CalibrationText::tr("The images of %1 are %2 times as large as those for which it was "
                               "calibrated: its intrinsics are for another resolution. Convert the "
                               "intrinsics, or record at the calibrated size.")
        .arg(first, ratioText(fault.value));
  }
}

} // namespace

QString accuracyText(const CalibrationAccuracy& accuracy) {
  const auto isKnown = [](const std::optional<double>& value) {
    return value && std::isfinite(*value);
  };
  const QString unknown = CalibrationText::tr("unknown");
  const QString position = isKnown(accuracy.positionError95)
                               ? CalibrationText::tr("±%1").arg(
                                     lengthText(accuracy.positionError95, LengthForm::TwoDigits))
                               : unknown;
  const QString scale =
      isKnown(accuracy.scaleError95)
          ? CalibrationText::tr("±%1 %").arg(percentAccuracyText(*accuracy.scaleError95))
          : unknown;
  const QString up =
      isKnown(accuracy.upAngleError95)
          ? CalibrationText::tr("±%1").arg(angleAccuracyText(*accuracy.upAngleError95))
          : CalibrationText::tr("not measured yet (use the page Floor)");
  const QString inside =
      CalibrationText::tr("In the calibrated volume: position %1, scale %2, upward direction %3 "
                          "(95 % of the errors are smaller).")
          .arg(position, scale, up);
  if (!isKnown(accuracy.outsidePositionError95)) {
    return inside;
  }
  return inside + QLatin1Char(' ') +
         CalibrationText::tr(
             "Outside the calibrated volume, up to %1 away: position ±%2 (extrapolated).")
             .arg(lengthText(accuracy.outsideRegionDepth, LengthForm::TwoDigits),
                  lengthText(*accuracy.outsidePositionError95, LengthForm::TwoDigits));
}

QString faultText(const DetectedFault& fault, const QStringList& cameraNames) {
  const auto name = [&](std::size_t k) {
    return k < fault.cameras.size() ? cameraNames.value(static_cast<qsizetype>(fault.cameras[k]))
                                    : CalibrationText::tr("all cameras");
  };
  switch (fault.fault) {
  case CalibrationFault::MirroredBoard:
    return CalibrationText::tr(
        "All cameras seem to see the board from behind, or the floor from below: the measured "
        "points are probably mirrored. Check the direction of the axes, and make sure that the "
        "printed board is not mirrored.");
  case CalibrationFault::WrongUnitMillimeters:
    return CalibrationText::tr("The length that you entered is %1 times the length that the "
                               "cameras see: millimeters and meters are probably mixed up.")
        .arg(ratioText(fault.value));
  case CalibrationFault::WrongUnitInches:
    return CalibrationText::tr("The length that you entered is %1 times the length that the "
                               "cameras see: you probably entered it in inches (1 inch = 2.54 cm).")
        .arg(ratioText(fault.value));
  case CalibrationFault::WrongSquareCount:
    return CalibrationText::tr(
               "The corners form a board with %1 squares in a row, so the number of squares that "
               "you entered is probably wrong. Count the squares and correct the number.")
        .arg(numberText(fault.value, 0));
  case CalibrationFault::WrongSquareSize:
    return CalibrationText::tr(
               "The size of the squares that you entered is %1 times the size that the cameras "
               "see. Measure a row with a ruler: prints are often rescaled.")
        .arg(ratioText(fault.value));
  case CalibrationFault::HalfPixel:
    return CalibrationText::tr(
               "The images fit only if they are shifted by %1 along both axes: the calibration "
               "probably counts pixel coordinates from the corner of the first pixel, not from its "
               "center. Convert the principal points.")
        .arg(pixelText(fault.value));
  default:
    return cameraFault(fault, name(0), name(1));
  }
}

} // namespace dewpoint::ui
