// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/wand/wand_outcome.h"

#include "ui/calibration/calibration_dock.h"
#include "ui/calibration/wand/wand_calibrator.h"
#include "ui/calibration/wand/wand_text.h"
#include "ui/text/calibration_text.h"
#include "ui/text/camera_names.h"
#include "ui/text/error_sentence.h"
#include "ui/text/quantity_text.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/named_widgets.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include <cmath>

namespace dewpoint::ui {
namespace {

enum OutcomeColumn { Name, Pixels, Moved, Turned, Offset, ColumnCount };

QLabel* makeOutcomeText(const char* name, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setObjectName(QLatin1String(name));
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  return label;
}

} // namespace

WandOutcome::WandOutcome(WandCalibrator& calibrator, QWidget* parent)
    : QWidget(parent), calibrator_(calibrator) {
  setObjectName(QStringLiteral("wandOutcome"));
  createWidgets();
  connectParts();
  onRetranslate(this, [this] { retranslateUi(); });
}

void WandOutcome::createWidgets() {
  missing_ = makeOutcomeText("wandMissing", this);
  refine_ = makeButton("wandRefine", this);
  progress_ = new QProgressBar(this);
  progress_->setObjectName(QStringLiteral("wandProgress"));
  cancel_ = makeButton("wandCancel", this);
  accuracy_ = makeOutcomeText("wandAssessment", this);
  QFont bold = accuracy_->font();
  bold.setBold(true);
  accuracy_->setFont(bold);
  accuracy_->setProperty(kRevealedProperty, true);
  notes_ = makeOutcomeText("wandNotes", this);
  table_ = new QTableWidget(0, ColumnCount, this);
  table_->setObjectName(QStringLiteral("wandCameras"));
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setTabKeyNavigation(false);
  table_->verticalHeader()->hide();
  table_->horizontalHeader()->setMinimumSectionSize(28);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(Name, QHeaderView::Stretch);
  table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  flip_ = makeButton("wandFlip", this);
  apply_ = makeButton("wandApply", this);
  report_ = makeButton("wandReport", this);
  auto* work = new QHBoxLayout;
  work->setSpacing(6);
  work->addWidget(progress_, 1);
  work->addWidget(cancel_);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(6);
  buttons->addWidget(flip_);
  buttons->addWidget(report_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  for (QWidget* part : std::initializer_list<QWidget*>{missing_, refine_}) {
    column->addWidget(part);
  }
  column->addLayout(work);
  for (QWidget* part : std::initializer_list<QWidget*>{accuracy_, notes_, apply_, table_}) {
    column->addWidget(part);
  }
  column->addLayout(buttons);
}

void WandOutcome::connectParts() {
  connect(&calibrator_, &WandCalibrator::changed, this, &WandOutcome::refresh);
  connect(&calibrator_, &WandCalibrator::collectorStateChanged, this,
          [this] { missing_->setText(calibrator_.reasonNotToRefine()); });
  connect(&calibrator_, &WandCalibrator::progressChanged, this, &WandOutcome::showProgress);
  connect(refine_, &QPushButton::clicked, &calibrator_, &WandCalibrator::refine);
  connect(cancel_, &QPushButton::clicked, &calibrator_, &WandCalibrator::cancel);
  connect(apply_, &QPushButton::clicked, &calibrator_, &WandCalibrator::apply);
  connect(flip_, &QPushButton::pressed, this,
          [this] { calibrator_.setBeforeRefinementShown(true); });
  connect(flip_, &QPushButton::released, this,
          [this] { calibrator_.setBeforeRefinementShown(false); });
  connect(report_, &QPushButton::clicked, this, &WandOutcome::chooseReport);
}

void WandOutcome::retranslateUi() {
  const auto button = [](QPushButton* one, const QString& text, const QString& tip) {
    one->setText(text);
    one->setAccessibleName(text);
    one->setToolTip(tip);
  };
  button(refine_, tr("Refine cameras"),
         tr("Detect the ball in all images and compute the cameras that fit best"));
  button(cancel_, tr("Cancel"), tr("Stop and keep the cameras unchanged"));
  progress_->setAccessibleName(tr("Progress"));
  button(flip_, tr("Before"),
         tr("Hold down this button to draw the grid with the calibration from before this "
            "refinement"));
  button(apply_, tr("Use calibration anyway"),
         tr("Use this calibration although it looks wrong; you can undo this"));
  button(
      report_, tr("Save report…"),
      tr("Save a page with all numbers, the residuals as arrows, the coverage and a 3D drawing"));
  table_->setAccessibleName(tr("Refined cameras"));
  table_->setToolTip(tr("Results for each camera; hover over a heading to see its meaning"));
  table_->setHorizontalHeaderLabels(
      {tr("Camera"), tr("px"), tr("moved cm"), tr("rotated °"), tr("delay ms")});
  const QStringList tips = {
      {},
      tr("Reprojection error: root mean square distance between detected and projected balls"),
      tr("Distance between the old and the new position of the camera"),
      tr("Angle between the old and the new orientation of the camera"),
      tr("Additional delay of this camera's images relative to the first camera")};
  for (int column = 0; column < ColumnCount; ++column) {
    table_->horizontalHeaderItem(column)->setToolTip(tips[column]);
  }
  refresh();
}

void WandOutcome::showProgress(double part) {
  progress_->setRange(0, part < 0.0 ? 0 : 1000);
  progress_->setValue(static_cast<int>(std::lround(std::max(0.0, part) * progress_->maximum())));
}

void WandOutcome::refresh() {
  const bool running = calibrator_.isRefining();
  const QString missing = calibrator_.reasonNotToRefine();
  missing_->setText(missing);
  missing_->setVisible(!missing.isEmpty() && !running);
  refine_->setEnabled(!running && missing.isEmpty());
  if (running && !progress_->isVisible()) {
    showProgress(-1.0);
  }
  progress_->setVisible(running);
  cancel_->setVisible(running);
  showOutcome();
}

void WandOutcome::showOutcome() {
  const auto found = calibrator_.refinement();
  const bool over = !calibrator_.isRefining();
  QStringList notes;
  QString accuracy;
  if (!calibrator_.failureText().isEmpty()) {
    accuracy = QStringLiteral("⚠ ") + calibrator_.failureText();
    notes << tr("The cameras are unchanged.");
  }
  if (found) {
    accuracy = found->accuracy ? accuracyText(*found->accuracy)
                               : QStringLiteral("⚠ ") + errorText(found->accuracy.error());
    if (calibrator_.isStale()) {
      notes << tr("The cameras have changed since this refinement.");
    }
    for (const DetectedFault& fault : found->result.faults) {
      notes << QStringLiteral("⚠ ") + faultText(fault, cameraNames(found->camerasBefore));
    }
    for (const FarOffCamera& camera : farOffCameras(*found)) {
      notes << QStringLiteral("⚠ ") +
                   tr("%1 was far off: the refinement rotates this camera by %2 and moves it by "
                      "%3, much more than the other cameras. Was it moved after its calibration?")
                       .arg(cameraName(found->camerasBefore, camera.camera),
                            angleText(camera.poseChange.radians, 1),
                            lengthText(camera.poseChange.meters, LengthScale::Centimeters, 1));
    }
    if (isInaccurate(*found)) {
      notes << QStringLiteral("⚠ ") +
                   tr("The result is less accurate than the initial camera positions: you entered "
                      "that their error is at most %1. Wave through more of the volume.")
                       .arg(lengthText(found->options.initialPositionError,
                                       LengthScale::Centimeters, 1));
    }
    if (isUnnecessary(*found)) {
      notes << QStringLiteral("⚠ ") +
                   tr("The previous calibration fits the images as well as the new one. Keep the "
                      "previous one, or wave longer and through more of the volume.");
    }
    if (areOldCamerasMoreAccurate(*found) && !isUnnecessary(*found)) {
      notes << QStringLiteral("⚠ ") + lessAccurateResultMessage(*found);
    }
    for (const MotionGap& gap : found->gaps) {
      notes << QStringLiteral("⚠ ") + motionGapMessage(gap, cameraNames(found->camerasBefore));
    }
    if (!calibrator_.isApplied()) {
      notes << tr("The cameras are unchanged.");
    }
    if (found->accuracy && found->accuracy->errorInflationFactor > 1.0) {
      notes << tr("Calibrations from different parts of the recording differ from each other %1 "
                  "times as much as image noise can explain. The stated accuracy takes this into "
                  "account.")
                   .arg(numberText(found->accuracy->errorInflationFactor, 1));
    }
    if (found->result.freeFall) {
      notes << tr("The fall gives a gravity of %1 m/s² (9.81 is expected).")
                   .arg(numberText(found->result.freeFall->gravity, 2));
    }
    if (found->options.estimatesTimeOffsets && calibrator_.isApplied()) {
      notes << tr(
          "Camera delays are saved in the project and used to synchronize images from now on.");
    }
  }
  accuracy_->setText(accuracy);
  accuracy_->setVisible(over && !accuracy.isEmpty());
  notes_->setText(notes.join(QStringLiteral("\n")));
  notes_->setVisible(over && !notes.isEmpty());
  const bool shown = over && found != nullptr;
  table_->setVisible(shown);
  flip_->setVisible(shown && calibrator_.isApplied());
  apply_->setVisible(shown && !calibrator_.isApplied());
  report_->setVisible(shown);
  if (shown) {
    fillTable();
  }
}

void WandOutcome::fillTable() {
  const WandRefinement& found = *calibrator_.refinement();
  const WandResult& result = found.result;
  table_->setRowCount(static_cast<int>(result.cameras.size()));
  table_->setColumnHidden(Offset, !found.options.estimatesTimeOffsets);
  const auto set = [this](std::size_t row, int column, const QString& text) {
    auto* item = new QTableWidgetItem(text);
    item->setTextAlignment((column == Name ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    table_->setItem(static_cast<int>(row), column, item);
  };
  for (std::size_t k = 0; k < result.cameras.size(); ++k) {
    const PoseShift shift = poseShift(found.camerasBefore[k], result.cameras[k]);
    set(k, Name, cameraName(found.camerasBefore, k));
    set(k, Pixels, numberText(result.bundle.cameraRmsPx[k], 2));
    set(k, Moved, lengthNumber(shift.meters, LengthScale::Centimeters, 1));
    set(k, Turned, angleNumber(shift.radians, 2));
    // True time is the camera's plus the offset: a late image has a negative one.
    set(k, Offset, millisecondsNumber(-result.timeOffsets[k], NumberForm::Signed));
  }
  table_->resizeRowsToContents();
  int height = table_->horizontalHeader()->sizeHint().height() + 2 * table_->frameWidth();
  for (int row = 0; row < table_->rowCount(); ++row) {
    height += table_->rowHeight(row);
  }
  table_->setFixedHeight(height);
}

void WandOutcome::chooseReport() {
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save the report"), QStringLiteral("calibration.html"), tr("Web pages (*.html)"));
  if (!file.isEmpty()) {
    calibrator_.saveReport(file);
  }
}

} // namespace dewpoint::ui
