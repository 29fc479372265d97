// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/wand/touched_instant_list.h"

#include "ui/calibration/wand/wand_calibrator.h"
#include "ui/text/quantity_text.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/number_field.h"

#include <QComboBox>
#include <QGridLayout>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>

namespace dewpoint::ui {

TouchedInstantList::TouchedInstantList(WandCalibrator& calibrator, QWidget* parent)
    : QWidget(parent), calibrator_(calibrator), role_(new QComboBox(this)),
      take_(new QPushButton(this)), list_(new QListWidget(this)), remove_(new QPushButton(this)) {
  setObjectName(QStringLiteral("wandMoments"));
  role_->setObjectName(QStringLiteral("wandRole"));
  makeNarrow(*role_);
  take_->setObjectName(QStringLiteral("wandTake"));
  list_->setObjectName(QStringLiteral("wandMomentList"));
  list_->setFixedHeight(60);
  remove_->setObjectName(QStringLiteral("wandRemove"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(6);
  grid->addWidget(role_, 0, 0, 1, 2);
  grid->addWidget(take_, 1, 0);
  grid->addWidget(remove_, 1, 1);
  grid->addWidget(list_, 2, 0, 1, 2);
  connect(&calibrator_, &WandCalibrator::changed, this, &TouchedInstantList::refresh);
  connect(take_, &QPushButton::clicked, this,
          [this] { calibrator_.markInstant(static_cast<WandEvent>(role_->currentIndex())); });
  connect(remove_, &QPushButton::clicked, this, [this] {
    calibrator_.removeMarkedInstant(static_cast<std::size_t>(list_->currentRow()));
  });
  connect(list_, &QListWidget::itemActivated, this,
          [this] { calibrator_.showMarkedInstant(static_cast<std::size_t>(list_->currentRow())); });
  connect(list_, &QListWidget::currentRowChanged, this,
          [this](int row) { remove_->setEnabled(row >= 0 && !calibrator_.isRefining()); });
  onRetranslate(this, [this] { retranslateUi(); });
}

void TouchedInstantList::retranslateUi() {
  {
    const QSignalBlocker quiet(role_);
    const int chosen = std::max(0, role_->currentIndex());
    role_->clear();
    for (int role = 0; role < kWandEventCount; ++role) {
      role_->addItem(wandEventText(static_cast<WandEvent>(role)));
    }
    role_->setCurrentIndex(chosen);
  }
  role_->setAccessibleName(tr("What the ball does at this time"));
  role_->setToolTip(tr("The upward direction is computed from three positions at which the ball "
                       "touches the floor, or from a fall of the ball"));
  take_->setText(tr("Add current time"));
  take_->setAccessibleName(take_->text());
  take_->setToolTip(tr("Add the time of the images shown to the list. In these images, the ball "
                       "must do what you selected"));
  remove_->setText(tr("Remove time"));
  remove_->setAccessibleName(remove_->text());
  remove_->setToolTip(tr("Remove the selected time from the list"));
  list_->setAccessibleName(tr("Added times"));
  list_->setToolTip(tr("Double-click or press Enter to show the images of this time"));
  refresh();
}

void TouchedInstantList::refresh() {
  const int chosen = list_->currentRow();
  {
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (const MarkedInstant& instant : calibrator_.markedInstants()) {
      list_->addItem(
          tr("%1 – %2").arg(secondsText(instant.recordingTime, 3), wandEventText(instant.event)));
    }
    list_->setCurrentRow(std::min(chosen, list_->count() - 1));
  }
  take_->setEnabled(calibrator_.canMarkInstant() && !calibrator_.isRefining());
  remove_->setEnabled(list_->currentRow() >= 0 && !calibrator_.isRefining());
}

} // namespace dewpoint::ui
