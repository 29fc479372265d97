// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/camera_agreement_text.h"

#include "ui/text/quantity_text.h"

#include <QCoreApplication>

#include <cmath>

namespace dewpoint::ui {
namespace {

QString translatedAgreement(const char* text) {
  return QCoreApplication::translate("CameraAgreement", text);
}

/// The name of the camera at this index of the fault's.
QString nameAt(const CameraDisagreement& found, std::size_t index, const QStringList& names) {
  return names.value(static_cast<int>(found.cameras.at(index)));
}

QString unitText(double meters) {
  constexpr double kTenMillimeters = 0.01; // meters
  if (meters < kTenMillimeters) {
    return translatedAgreement(QT_TRANSLATE_NOOP("CameraAgreement", "millimeters"));
  }
  return meters > kTenMillimeters
             ? translatedAgreement(QT_TRANSLATE_NOOP("CameraAgreement", "inches"))
             : translatedAgreement(QT_TRANSLATE_NOOP("CameraAgreement", "centimeters"));
}

QString swappedText(const CameraDisagreement& found, const QStringList& names) {
  const QString first = nameAt(found, 0, names);
  const QString second = nameAt(found, 1, names);
  if (found.cameras.size() > 2) {
    return translatedAgreement(
               QT_TRANSLATE_NOOP("CameraAgreement", "%1 and %2 seem to be swapped, or %3 and %4."))
        .arg(first, second, nameAt(found, 2, names), nameAt(found, 3, names));
  }
  return translatedAgreement(QT_TRANSLATE_NOOP("CameraAgreement", "%1 and %2 seem to be swapped."))
      .arg(first, second);
}

QString rotatedText(const CameraDisagreement& found, const QStringList& names) {
  const QString angle = angleText(found.rotationCorrections.at(0).norm(), 1);
  if (found.cameras.size() > 1) {
    return translatedAgreement(
               QT_TRANSLATE_NOOP("CameraAgreement",
                                 "%1 or %2 points at least %3 away from its calibrated direction."))
        .arg(nameAt(found, 0, names), nameAt(found, 1, names), angle);
  }
  return translatedAgreement(
             QT_TRANSLATE_NOOP("CameraAgreement",
                               "%1 points about %2 away from its calibrated direction."))
      .arg(nameAt(found, 0, names), angle);
}

QString unknownText(const CameraDisagreement& found, const QStringList& names) {
  if (found.cameras.size() > 1) {
    return translatedAgreement(
               QT_TRANSLATE_NOOP(
                   "CameraAgreement",
                   "%1 and %2 disagree about where the target is. Calibrate them again."))
        .arg(nameAt(found, 0, names), nameAt(found, 1, names));
  }
  return translatedAgreement(
             QT_TRANSLATE_NOOP("CameraAgreement",
                               "%1 does not agree with the other cameras. Calibrate it "
                               "again."))
      .arg(nameAt(found, 0, names));
}

} // namespace

QString disagreementText(const CameraDisagreement& found, const QStringList& names) {
  switch (found.fault) {
  case CameraFault::Swapped:
    return swappedText(found, names);
  case CameraFault::Late: {
    const QString by = secondsText(std::abs(found.delay), 2);
    const QString text =
        found.delay > 0.0
            ? translatedAgreement(
                  QT_TRANSLATE_NOOP("CameraAgreement", "The images of %1 are about %2 late."))
            : translatedAgreement(
                  QT_TRANSLATE_NOOP("CameraAgreement", "The images of %1 are about %2 early."));
    return text.arg(nameAt(found, 0, names), by);
  }
  case CameraFault::Rotated:
    return rotatedText(found, names);
  case CameraFault::Unit:
    return translatedAgreement(
               QT_TRANSLATE_NOOP("CameraAgreement",
                                 "The calibration seems to be in %1 instead of meters."))
        .arg(unitText(found.metersPerUnit));
  case CameraFault::SamePose:
    return translatedAgreement(
               QT_TRANSLATE_NOOP("CameraAgreement", "%1 and %2 have the same pose."))
        .arg(nameAt(found, 0, names), nameAt(found, 1, names));
  case CameraFault::Unknown:
    break;
  }
  return unknownText(found, names);
}

QString rigCorrectionText(const CameraDisagreement& found, std::size_t choice,
                          const QStringList& names) {
  switch (found.fault) {
  case CameraFault::Swapped:
    return translatedAgreement(QT_TRANSLATE_NOOP("CameraAgreement", "Swap %1 and %2"))
        .arg(nameAt(found, 2 * choice, names), nameAt(found, 2 * choice + 1, names));
  case CameraFault::Late:
    return translatedAgreement(QT_TRANSLATE_NOOP("CameraAgreement", "Set the delay of %1"))
        .arg(nameAt(found, choice, names));
  case CameraFault::Rotated:
    return translatedAgreement(QT_TRANSLATE_NOOP("CameraAgreement", "Correct direction of %1"))
        .arg(nameAt(found, choice, names));
  case CameraFault::Unit:
    return translatedAgreement(QT_TRANSLATE_NOOP("CameraAgreement", "Convert to meters"));
  case CameraFault::SamePose:
  case CameraFault::Unknown:
    break;
  }
  return {};
}

} // namespace dewpoint::ui
