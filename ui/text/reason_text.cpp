// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/reason_text.h"

#include "ui/text/camera_names.h"
#include "ui/text/quantity_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

namespace {

class Reason {
  Q_DECLARE_TR_FUNCTIONS(Reason)
};

} // namespace

QString cameraReasonText(const CameraReport& report) {
  const QString distance = pixelText(std::max(1.0, std::round(report.outlineDistancePx)), 0);
  switch (report.status) {
  case CameraStatus::None:
    break;
  case CameraStatus::NoImage:
    return Reason::tr("no image");
  case CameraStatus::Covered:
    return Reason::tr("camera covered or moved");
  case CameraStatus::Dark:
    return Reason::tr("too dark");
  case CameraStatus::OutOfView:
    return Reason::tr("out of view");
  case CameraStatus::PartlyHidden:
    return Reason::tr("partly hidden");
  case CameraStatus::Hidden:
    return Reason::tr("hidden");
  case CameraStatus::Distractor:
    return report.outlineDistancePx < 1.0 ? Reason::tr("at a distractor")
                                          : Reason::tr("%1 away from a distractor").arg(distance);
  case CameraStatus::NoColor:
    return Reason::tr("no matching color");
  case CameraStatus::Elsewhere:
    return Reason::tr("color found %1 away").arg(distance);
  case CameraStatus::Unclear:
    return Reason::tr("right color, wrong shape");
  }
  return {};
}

QString cameraReasonTextInImage(const CameraReport& report) {
  switch (report.status) {
  case CameraStatus::Hidden:
    return Reason::tr("hidden here");
  case CameraStatus::OutOfView:
    return Reason::tr("not in this image");
  case CameraStatus::None:
  case CameraStatus::NoImage:
  case CameraStatus::Covered:
  case CameraStatus::Dark:
  case CameraStatus::PartlyHidden:
  case CameraStatus::Distractor:
  case CameraStatus::NoColor:
  case CameraStatus::Elsewhere:
  case CameraStatus::Unclear:
    break;
  }
  return cameraReasonText(report);
}

bool isCameraBlind(const CameraReport& report) {
  return report.status == CameraStatus::Hidden || report.status == CameraStatus::OutOfView ||
         report.status == CameraStatus::Covered || report.status == CameraStatus::Dark ||
         report.status == CameraStatus::NoColor;
}

QString cameraBlindText(const CameraReport& report) {
  return QStringLiteral("◌ ") + cameraReasonTextInImage(report);
}

QString reasonText(const std::vector<CameraReport>& reports, const QStringList& cameraNames) {
  QStringList troubles; // in the order of the cameras, each once
  QList<QStringList> cameras;
  for (std::size_t k = 0; k < reports.size(); ++k) {
    const QString trouble = cameraReasonText(reports[k]);
    if (trouble.isEmpty()) {
      continue;
    }
    if (!troubles.contains(trouble)) {
      troubles.append(trouble);
      cameras.emplace_back();
    }
    cameras[troubles.indexOf(trouble)].append(cameraNames.value(static_cast<int>(k)));
  }
  QStringList parts;
  for (qsizetype k = 0; k < troubles.size(); ++k) {
    parts.append(QStringLiteral("%1: %2").arg(cameras[k].join(QStringLiteral(", ")), troubles[k]));
  }
  return parts.join(QStringLiteral(" · "));
}

QStringList cameraNames(const TrackSnapshot& snapshot) {
  return snapshot.rig ? cameraNames(*snapshot.rig) : QStringList();
}

} // namespace dewpoint::ui
