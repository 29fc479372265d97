// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/manual/manual_calibration_page.h"

#include "ui/calibration/manual/camera_form.h"
#include "ui/calibration/manual/grid_form.h"
#include "ui/calibration/manual_calibration.h"
#include "ui/calibration/points/point_calibrator.h"
#include "ui/calibration/points/points_table.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/page_title.h"

#include <QLabel>
#include <QShortcut>
#include <QVBoxLayout>

namespace dewpoint::ui {

ManualCalibrationPage::ManualCalibrationPage(ManualCalibration& manual, PointCalibrator& points,
                                             QWidget* parent)
    : QWidget(parent), guide_(new QLabel(this)), remark_(new QLabel(this)),
      cameraTitle_(makePageTitle(this)), gridTitle_(makePageTitle(this)),
      pointsTitle_(makePageTitle(this)) {
  setObjectName(QStringLiteral("handPage"));
  guide_->setWordWrap(true);
  remark_->setObjectName(QStringLiteral("handRemark"));
  remark_->setWordWrap(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  column->addWidget(guide_);
  column->addWidget(remark_);
  column->addWidget(cameraTitle_);
  column->addWidget(new CameraForm(manual, this));
  column->addWidget(gridTitle_);
  column->addWidget(new GridForm(manual, this));
  column->addWidget(pointsTitle_);
  column->addWidget(new PointsTable(points, manual, this));
  column->addStretch(1);
  remark_->hide();
  connect(&manual, &ManualCalibration::messageRequested, this, [this](const QString& sentence) {
    remark_->setText(QStringLiteral("⚠ ") + sentence);
    remark_->setVisible(!sentence.isEmpty());
  });
  makeReleaseKey(manual, points);
  onRetranslate(this, [this] { retranslateUi(); });
}

void ManualCalibrationPage::makeReleaseKey(ManualCalibration& manual, PointCalibrator& points) {
  auto* release = new QShortcut(Qt::Key_Escape, this); // of the window, while the page is shown
  release->setAutoRepeat(false);
  // Without a held point, Esc belongs to the rest of the window.
  const auto follow = [release, &manual, &points] {
    release->setEnabled(manual.takesClicks() && manual.hasPins() && !points.clicksPlacePoint());
  };
  follow();
  connect(&manual, &ManualCalibration::changed, release, follow);
  connect(&points, &PointCalibrator::changed, release, follow);
  connect(release, &QShortcut::activated, &manual, &ManualCalibration::clearPins);
}

void ManualCalibrationPage::retranslateUi() {
  guide_->setText(
      tr("Drag the grid in an image until it matches the real scene. Click a grid "
         "point to hold it in place. Turn the wheel to zoom; double-click beside the grid "
         "points to see the whole image."));
  cameraTitle_->setText(tr("Camera"));
  gridTitle_->setText(tr("Reference grid"));
  pointsTitle_->setText(tr("Measured points"));
}

} // namespace dewpoint::ui
