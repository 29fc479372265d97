// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/calibration_place.h"

#include "ui/settings/retranslation.h"

#include <QScrollArea>
#include <QTabWidget>
#include <QVBoxLayout>

namespace dewpoint {

CalibrationPlace::CalibrationPlace(QWidget* parent) : QWidget(parent), tabs_(new QTabWidget(this)) {
  setObjectName(QStringLiteral("calibrationPlace"));
  tabs_->setObjectName(QStringLiteral("calibrationPages"));
  tabs_->setDocumentMode(true);
  tabs_->setTabBarAutoHide(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(tabs_);
  inEveryLanguage(this, [this] { tabs_->setAccessibleName(tr("Ways to calibrate")); });
  connect(tabs_, &QTabWidget::currentChanged, this, [this] { Q_EMIT pageChanged(shownPage()); });
}

void CalibrationPlace::addPage(QWidget* page, const std::function<QString()>& title) {
  auto* scroll = new QScrollArea(tabs_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(page);
  tabs_->addTab(scroll, QString());
  inEveryLanguage(scroll,
                  [this, scroll, title] { tabs_->setTabText(tabs_->indexOf(scroll), title()); });
}

void CalibrationPlace::showPage(const QString& name) {
  for (int k = 0; k < tabs_->count(); ++k) {
    if (static_cast<QScrollArea*>(tabs_->widget(k))->widget()->objectName() == name) {
      tabs_->setCurrentIndex(k);
    }
  }
}

QString CalibrationPlace::shownPage() const {
  const auto* scroll = static_cast<QScrollArea*>(tabs_->currentWidget());
  return scroll != nullptr ? scroll->widget()->objectName() : QString();
}

} // namespace dewpoint
