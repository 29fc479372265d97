// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/board/board_calibration_page.h"

#include "ui/calibration/board/board_calibrator.h"
#include "ui/calibration/board/board_form.h"
#include "ui/calibration/board/board_goal_form.h"
#include "ui/calibration/board/board_live.h"
#include "ui/calibration/board/board_text.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/page_title.h"

#include <QDesktopServices>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>
#include <QUrl>
#include <QVBoxLayout>

namespace dewpoint::ui {
namespace {

constexpr int kProgressSteps = 1000;

} // namespace

BoardCalibrationPage::BoardCalibrationPage(BoardCalibrator& calibrator, QWidget* parent)
    : QWidget(parent), calibrator_(calibrator) {
  setObjectName(QStringLiteral("boardPage"));
  createWidgets();
  connect(find_, &QPushButton::clicked, &calibrator_, &BoardCalibrator::identifyBoard);
  connect(calibrate_, &QPushButton::clicked, &calibrator_, &BoardCalibrator::calibrate);
  connect(cancel_, &QPushButton::clicked, &calibrator_, &BoardCalibrator::cancel);
  connect(apply_, &QPushButton::clicked, &calibrator_, &BoardCalibrator::apply);
  connect(report_, &QPushButton::clicked, this, &BoardCalibrationPage::chooseReportFile);
  connect(&calibrator_, &BoardCalibrator::changed, this, &BoardCalibrationPage::refresh);
  connect(&calibrator_, &BoardCalibrator::guideRequestChanged, this,
          &BoardCalibrationPage::refresh);
  connect(&calibrator_, &BoardCalibrator::calibrationEnded, this, [this] {
    QTimer::singleShot(0, this, &BoardCalibrationPage::showResult); // laid out by then
  });
  connect(&calibrator_, &BoardCalibrator::progressChanged, this,
          &BoardCalibrationPage::showProgress);
  onRetranslate(this, [this] { retranslateUi(); });
}

void BoardCalibrationPage::createWidgets() {
  guide_ = new QLabel(this);
  guide_->setWordWrap(true);
  boardTitle_ = makePageTitle(this);
  fields_ = new BoardForm(calibrator_, this);
  goalTitle_ = makePageTitle(this);
  auto* goal = new BoardGoalForm(calibrator_, this);
  runTitle_ = makePageTitle(this);
  const auto button = [this](const char* name) {
    auto* made = new QPushButton(this);
    made->setObjectName(QLatin1String(name));
    return made;
  };
  find_ = button("boardFind");
  calibrate_ = button("boardCalibrate");
  cancel_ = button("boardCancel");
  apply_ = button("boardApply");
  report_ = button("boardReport");
  progress_ = new QProgressBar(this);
  progress_->setObjectName(QStringLiteral("boardProgress"));
  live_ = new BoardLive(calibrator_, this);
  result_ = new QLabel(this);
  result_->setObjectName(QStringLiteral("boardResult"));
  result_->setWordWrap(true);
  result_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  auto* run = new QHBoxLayout;
  run->addWidget(calibrate_, 1);
  run->addWidget(progress_, 2);
  run->addWidget(cancel_);
  auto* after = new QHBoxLayout;
  after->addWidget(apply_, 1);
  after->addWidget(report_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 8);
  column->setSpacing(8);
  column->addWidget(guide_);
  column->addWidget(boardTitle_);
  column->addWidget(fields_);
  column->addWidget(find_);
  column->addWidget(goalTitle_);
  column->addWidget(goal);
  column->addWidget(runTitle_);
  column->addWidget(live_);
  column->addLayout(run);
  column->addWidget(result_);
  column->addLayout(after);
  column->addStretch(1);
}

void BoardCalibrationPage::print() {
  fields_->print();
}

void BoardCalibrationPage::retranslateUi() {
  boardTitle_->setText(tr("Board"));
  goalTitle_->setText(tr("Values to calibrate"));
  find_->setText(tr("Find board"));
  find_->setToolTip(
      tr("Find out from the images which kind of board they show, how many squares it has, and its "
         "dictionary. The images do not show how large the squares are: measure this yourself"));
  calibrate_->setText(tr("Calibrate"));
  calibrate_->setToolTip(
      tr("Find the board in the recording and calibrate the cameras with it (one undo step)"));
  cancel_->setText(tr("Cancel"));
  cancel_->setToolTip(tr("Stop and keep the previous calibration"));
  apply_->setText(tr("Apply"));
  apply_->setToolTip(tr("Use the calibration in the project (one undo step)"));
  report_->setText(tr("Report…"));
  report_->setToolTip(
      tr("Save a page with the residuals, coverage and errors of all images, and open it"));
  progress_->setAccessibleName(tr("Calibration progress"));
  refresh();
}

void BoardCalibrationPage::refresh() {
  const bool live = calibrator_.usesLiveCameras();
  const bool computing = calibrator_.isComputing();
  const auto outcome = calibrator_.outcome();
  guide_->setText(live
                      ? tr("Show a printed board to the cameras. This page says what to show "
                           "next. A view is captured when you hold the board still.")
                      : tr("To calibrate from a recording, record a printed board that you hold "
                           "still in many positions, some of them close to the camera or tilted."));
  runTitle_->setText(live ? tr("Live cameras") : tr("This recording"));
  live_->setVisible(live);
  find_->setEnabled(!computing && calibrator_.shownFrame() >= 0);
  calibrate_->setVisible(!live && !computing);
  calibrate_->setEnabled(calibrator_.shownFrame() >= 0);
  progress_->setVisible(computing);
  cancel_->setVisible(computing);
  apply_->setVisible(outcome != nullptr && !calibrator_.isApplied());
  const bool doubted =
      outcome != nullptr && outcome->extrinsics && !outcome->extrinsics->faults.empty();
  apply_->setText(doubted ? tr("Use calibration anyway") : tr("Apply"));
  report_->setVisible(outcome != nullptr);
  QString text = outcome ? outcomeText(calibrator_, *outcome) : QString();
  if (!calibrator_.failureText().isEmpty()) {
    text = QStringLiteral("⚠ ") + calibrator_.failureText();
  } else if (calibrator_.isApplied()) {
    text = tr("✓ The cameras are calibrated (Ctrl+Z undoes this).") + QLatin1Char('\n') + text;
  }
  result_->setText(text);
  result_->setVisible(!text.isEmpty());
  if (computing) {
    showProgress(calibrator_.isSearchingRecording() ? 0.0 : -1.0);
  }
}

void BoardCalibrationPage::showProgress(double part) {
  progress_->setRange(0, part < 0.0 ? 0 : kProgressSteps);
  progress_->setValue(static_cast<int>(part * kProgressSteps));
  progress_->setFormat(calibrator_.isSearchingRecording() ? tr("Looking for the board: %p %")
                                                          : tr("Computing"));
}

void BoardCalibrationPage::showResult() {
  for (QWidget* parent = parentWidget(); parent != nullptr; parent = parent->parentWidget()) {
    if (auto* scroll = qobject_cast<QScrollArea*>(parent)) {
      scroll->ensureWidgetVisible(report_->isVisible() ? static_cast<QWidget*>(report_) : result_);
      return;
    }
  }
}

void BoardCalibrationPage::chooseReportFile() {
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save the report"), QStringLiteral("calibration.html"), tr("Page (*.html)"));
  if (!file.isEmpty()) {
    connect(
        &calibrator_, &BoardCalibrator::saved, this,
        [file](const QString& saved) {
          if (saved == file) {
            QDesktopServices::openUrl(QUrl::fromLocalFile(saved));
          }
        },
        Qt::SingleShotConnection);
    calibrator_.saveReport(file);
  }
}

} // namespace dewpoint::ui
