// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/manual/manual_installer.h"

#include "ui/calibration/calibration_mode.h"
#include "ui/calibration/manual/grid_layer.h"
#include "ui/calibration/manual/manual_calibration_page.h"
#include "ui/calibration/manual_calibration.h"
#include "ui/calibration/points/point_calibrator.h"
#include "ui/cameraview/camera_docks.h"
#include "ui/cameraview/camera_view.h"

#include <QAction>

namespace dewpoint::ui {

void installManualCalibration(const Workbench& bench, CalibrationMode& mode,
                              const CameraDocks& cameras) {
  ManualCalibration* manual = &mode.manualCalibration();
  auto* points = new PointCalibrator(bench.document, *manual, &mode);
  mode.addPage(new ManualCalibrationPage(*manual, *points),
               [] { return ManualCalibrationPage::tr("By hand"); });
  QObject::connect(&mode, &CalibrationMode::pageChanged, points, [points] {
    points->setClicksPlacePoint(false); // its magnifier belongs to the page that was left
  });
  QObject::connect(&mode, &CalibrationMode::imageClicksTakenOver, points,
                   [points] { points->setClicksPlacePoint(false); });
  QObject::connect(points, &PointCalibrator::changed, &mode, [bench, points] {
    if (points->clicksPlacePoint()) {
      bench.action("actionLearnColor")->setChecked(false);
    }
  });
  QObject::connect(&cameras, &CameraDocks::viewCreated, points,
                   [bench, manual, points](int camera, CameraView* view) {
                     bench.connectImageView(new GridLayer(camera, view, *manual, *points));
                   });
}

} // namespace dewpoint::ui
