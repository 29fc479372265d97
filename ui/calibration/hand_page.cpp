// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/hand_page.h"

#include "ui/calibration/camera_fields.h"
#include "ui/calibration/grid_fields.h"
#include "ui/calibration/hand_desk.h"
#include "ui/calibration/page_title.h"
#include "ui/calibration/point_desk.h"
#include "ui/calibration/points_table.h"
#include "ui/settings/retranslation.h"

#include <QLabel>
#include <QVBoxLayout>

namespace dewpoint {

HandPage::HandPage(HandDesk& hand, PointDesk& points, QWidget* parent)
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
  column->addWidget(new CameraFields(hand, this));
  column->addWidget(gridTitle_);
  column->addWidget(new GridFields(hand, this));
  column->addWidget(pointsTitle_);
  column->addWidget(new PointsTable(points, hand, this));
  column->addStretch(1);
  remark_->hide();
  connect(&hand, &HandDesk::remark, this, [this](const QString& sentence) {
    remark_->setText(QStringLiteral("⚠ ") + sentence);
    remark_->setVisible(!sentence.isEmpty());
  });
  inEveryLanguage(this, [this] { say(); });
}

void HandPage::say() {
  guide_->setText(tr("Drag the grid in an image until it lies on the real thing. Click a point of "
                     "it to hold it there."));
  cameraTitle_->setText(tr("Camera"));
  gridTitle_->setText(tr("Reference grid"));
  pointsTitle_->setText(tr("Measured points"));
}

} // namespace dewpoint
