// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/guide/guide_page.h"

#include "core/base/units.h"
#include "ui/calibration/guide/calibration_guide.h"
#include "ui/calibration/guide/guide_text.h"
#include "ui/document/camera_list_model.h"
#include "ui/text/quantity_text.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/named_widgets.h"
#include "ui/widgets/page_title.h"

#include <QButtonGroup>
#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace dewpoint::ui {
namespace {

/// More cameras are scrolled to.
constexpr int kMostRows = 9;

QLabel* makeText(const char* name, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(QLatin1String(name));
  label->setWordWrap(true);
  return label;
}

QString marked(const ItemStatus& part, const QString& text) {
  return statusSymbol(part) + QLatin1Char(' ') + text;
}

} // namespace

GuidePage::GuidePage(CalibrationGuide& guide, const CameraListModel& cameras, QWidget* parent)
    : QWidget(parent), guide_(guide), cameras_(cameras) {
  setObjectName(QStringLiteral("guidePage"));
  build();
  connectFields();
  onRetranslate(this, [this] { retranslateUi(); });
}

void GuidePage::build() {
  knownTitle_ = makePageTitle(this);
  table_ = new QTableWidget(0, ColumnCount, this);
  table_->setObjectName(QStringLiteral("guideKnown"));
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setTabKeyNavigation(false); // Tab goes on to the ways
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(Position, QHeaderView::Stretch);
  world_ = makeText("guideWorld", this);
  waysTitle_ = makePageTitle(this);
  needs_ = makeText("guideNeeds", this);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  column->addWidget(knownTitle_);
  column->addWidget(table_);
  column->addWidget(world_);
  column->addWidget(waysTitle_);
  group_ = new QButtonGroup(this);
  choices_ = new QWidget(this);
  auto* ways = new QVBoxLayout(choices_);
  ways->setContentsMargins(0, 0, 0, 0);
  ways->setSpacing(4);
  for (int way = 0; way < kWays; ++way) {
    auto* choice = new QRadioButton(choices_);
    choice->setObjectName(QStringLiteral("guideWay%1").arg(way));
    group_->addButton(choice, way);
    ways->addWidget(choice);
    ways_[static_cast<std::size_t>(way)] = choice;
  }
  column->addWidget(choices_);
  column->addWidget(needs_);
  other_ = makeButton("guideOther", this);
  column->addWidget(other_, 0, Qt::AlignLeft);
  column->addWidget(makeSteps());
  column->addStretch(1);
}

QWidget* GuidePage::makeSteps() {
  steps_ = new QWidget(this);
  stepTitle_ = makePageTitle(steps_);
  stepTitle_->setObjectName(QStringLiteral("guideStepTitle"));
  stepTitle_->setWordWrap(true);
  how_ = makeText("guideHow", steps_);
  reached_ = makeText("guideReached", steps_);
  open_ = makeButton("guideOpen", steps_);
  back_ = makeButton("guideBack", steps_);
  next_ = makeButton("guideNext", steps_);
  auto* grid = new QGridLayout(steps_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(8);
  grid->addWidget(stepTitle_, 0, 0, 1, 2);
  grid->addWidget(how_, 1, 0, 1, 2);
  grid->addWidget(reached_, 2, 0, 1, 2);
  grid->addWidget(open_, 3, 0, 1, 2);
  grid->addWidget(back_, 4, 0);
  grid->addWidget(next_, 4, 1);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  return steps_;
}

void GuidePage::connectFields() {
  connect(&guide_, &CalibrationGuide::changed, this, &GuidePage::refresh);
  connect(group_, &QButtonGroup::idClicked, this, [this](int way) {
    choosing_ = false;
    guide_.setProcedure(static_cast<CalibrationProcedure>(way));
  });
  connect(other_, &QPushButton::clicked, this, [this] {
    choosing_ = true;
    refresh();
  });
  connect(open_, &QPushButton::clicked, this, [this] {
    Q_EMIT guide_.openRequested(guide_.steps().at(static_cast<std::size_t>(guide_.currentStep())));
  });
  connect(back_, &QPushButton::clicked, this,
          [this] { guide_.goToStep(guide_.currentStep() - 1); });
  connect(next_, &QPushButton::clicked, this,
          [this] { guide_.goToStep(guide_.currentStep() + 1); });
}

void GuidePage::retranslateUi() {
  knownTitle_->setText(tr("Calibration so far"));
  table_->setHorizontalHeaderLabels({tr("Camera"), tr("Lens"), tr("Position"), tr("Delay")});
  table_->setAccessibleName(tr("Calibration of each camera so far"));
  table_->setToolTip(
      tr("✓ measured with this program; ± is the standard deviation. ○ entered, set by hand or "
         "read from a file, and not checked. ⚠ only a guess, or too inaccurate."));
  for (int way = 0; way < kWays; ++way) {
    const ProcedureText text = procedureText(static_cast<CalibrationProcedure>(way));
    QRadioButton* choice = ways_[static_cast<std::size_t>(way)];
    choice->setText(text.title);
    choice->setToolTip(text.requirements);
  }
  other_->setText(tr("Another way…"));
  other_->setToolTip(tr("Show all ways to calibrate. The calibration so far is kept."));
  back_->setText(tr("Back"));
  back_->setToolTip(tr("Show the previous step"));
  next_->setText(tr("Next"));
  next_->setToolTip(tr("Show the next step"));
  refresh();
}

void GuidePage::refreshTable() {
  const auto& cameras = guide_.status().cameras;
  table_->setRowCount(static_cast<int>(cameras.size()));
  const auto set = [this](int row, int column, const QString& text) {
    QTableWidgetItem* item = table_->item(row, column);
    if (item == nullptr) {
      item = new QTableWidgetItem;
      table_->setItem(row, column, item);
    }
    item->setText(text);
  };
  for (int row = 0; row < table_->rowCount(); ++row) {
    const CameraCalibrationStatus& camera = cameras[static_cast<std::size_t>(row)];
    set(row, Name, cameras_.index(row).data().toString());
    set(row, Lens, marked(camera.lens, lensText(camera.lens)));
    set(row, Position, marked(camera.pose, poseText(camera.pose)));
    set(row, Delay,
        camera.delaySeconds == 0.0 ? QStringLiteral("–")
                                   : millisecondsText(inMilliseconds(camera.delaySeconds)));
  }
  int height = table_->horizontalHeader()->sizeHint().height() + 2 * table_->frameWidth();
  for (int row = 0; row < std::min(kMostRows, table_->rowCount()); ++row) {
    height += table_->rowHeight(row);
  }
  table_->setFixedHeight(height);
  const CalibrationStatus& status = guide_.status();
  QStringList lines{
      tr("%1 Scale: %2").arg(statusSymbol(status.scale), scaleText(status.scale)),
      tr("%1 Floor and upward direction: %2")
          .arg(statusSymbol(status.floor), floorText(status.floor, status.isUpright))};
  if (status.errorInVolume) {
    lines << tr("✓ Accuracy in the calibrated volume: %1 (95 %)")
                 .arg(lengthText(*status.errorInVolume, LengthForm::TwoDigits));
  } else {
    lines << tr("○ Accuracy in the calibrated volume: not measured");
  }
  if (status.errorOutsideVolume) {
    lines << tr("○ Accuracy outside this volume: %1 (95 %, extrapolated)")
                 .arg(lengthText(*status.errorOutsideVolume, LengthForm::TwoDigits));
  }
  if (status.lengthCheck) {
    lines << tr("✓ Length check: you measured %1, the calibration gives %2")
                 .arg(lengthText(status.lengthCheck->measuredLength, LengthScale::Meters, 4),
                      lengthText(status.lengthCheck->calibratedLength, LengthScale::Meters, 4));
  }
  world_->setText(lines.join(QLatin1Char('\n')));
}

void GuidePage::refreshStep() {
  const auto steps = guide_.steps();
  const bool isChosen = !steps.empty() && !choosing_;
  steps_->setVisible(isChosen);
  needs_->setVisible(isChosen);
  other_->setVisible(isChosen);
  choices_->setVisible(!isChosen);
  waysTitle_->setText(isChosen ? procedureText(*guide_.procedure()).title
                               : tr("Choose a way to calibrate"));
  if (!isChosen) {
    return;
  }
  needs_->setText(procedureText(*guide_.procedure()).requirements);
  const auto current = static_cast<std::size_t>(guide_.currentStep());
  const StepText text = stepText(steps[current]);
  const StepProgress progress = guide_.progressOf(steps[current]);
  stepTitle_->setText(tr("Step %1 of %2: %3").arg(current + 1).arg(steps.size()).arg(text.title));
  how_->setText(text.instructions);
  reached_->setText((progress.isDone() ? QStringLiteral("✓ ") : QStringLiteral("○ ")) +
                    progressText(steps[current], progress));
  open_->setText(text.openButtonText);
  open_->setToolTip(text.title);
  back_->setEnabled(current > 0);
  next_->setEnabled(current + 1 < steps.size());
}

void GuidePage::refresh() {
  refreshTable();
  if (const auto way = guide_.procedure()) {
    ways_.at(static_cast<std::size_t>(*way))->setChecked(true);
  } else if (QAbstractButton* checked = group_->checkedButton()) {
    group_->setExclusive(false); // a group does not let go of its last choice otherwise
    checked->setChecked(false);
    group_->setExclusive(true);
  }
  refreshStep();
}

} // namespace dewpoint::ui
