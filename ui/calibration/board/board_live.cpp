// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/board/board_live.h"

#include "ui/calibration/board/board_calibrator.h"
#include "ui/calibration/board/board_map.h"
#include "ui/calibration/board/board_text.h"
#include "ui/calibration/board/room_display.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/named_widgets.h"

#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace dewpoint::ui {
namespace {

constexpr int kHeldSteps = 100;

} // namespace

BoardLive::BoardLive(BoardCalibrator& calibrator, QWidget* parent)
    : QWidget(parent), calibrator_(calibrator) {
  setObjectName(QStringLiteral("boardLive"));
  createWidgets();
  connect(start_, &QPushButton::clicked, &calibrator_, &BoardCalibrator::startGuidance);
  connect(capture_, &QPushButton::clicked, &calibrator_, &BoardCalibrator::captureNow);
  connect(floor_, &QPushButton::clicked, &calibrator_, &BoardCalibrator::captureFloor);
  connect(next_, &QPushButton::clicked, &calibrator_, &BoardCalibrator::skipToPoses);
  connect(display_, &QPushButton::clicked, this, [this] {
    auto* display = window()->findChild<RoomDisplay*>();
    if (display == nullptr) {
      display = new RoomDisplay(calibrator_, window());
      display->showMaximized();
    }
    display->raise();
    display->activateWindow();
  });
  connect(finish_, &QPushButton::clicked, &calibrator_,
          &BoardCalibrator::calibrateFromCapturedViews);
  connect(&calibrator_, &BoardCalibrator::changed, this, &BoardLive::refresh);
  connect(&calibrator_, &BoardCalibrator::guideRequestChanged, this, &BoardLive::refresh);
  connect(&calibrator_, &BoardCalibrator::guideChanged, this, &BoardLive::refresh);
  onRetranslate(this, [this] { retranslateUi(); });
}

void BoardLive::createWidgets() {
  start_ = makeButton("boardStart", this);
  capture_ = makeButton("boardCapture", this);
  floor_ = makeButton("boardFloorNow", this);
  next_ = makeButton("boardNext", this);
  display_ = makeButton("boardDisplay", this);
  finish_ = makeButton("boardFinish", this);
  overall_ = new QLabel(this);
  overall_->setObjectName(QStringLiteral("boardOverall"));
  overall_->setWordWrap(true);
  list_ = new QWidget(this);
  grid_ = new QGridLayout(list_);
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(8);
  grid_->setVerticalSpacing(8);
  grid_->setColumnStretch(1, 1);
  auto* buttons = new QGridLayout;
  buttons->setSpacing(6);
  buttons->addWidget(start_, 0, 0);
  buttons->addWidget(capture_, 0, 1);
  buttons->addWidget(floor_, 1, 0);
  buttons->addWidget(next_, 1, 1);
  buttons->addWidget(display_, 2, 0, 1, 2);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addLayout(buttons);
  column->addWidget(overall_);
  column->addWidget(list_);
  column->addWidget(finish_);
}

void BoardLive::makeRows(std::size_t count) {
  for (const Row& row : rows_) {
    delete row.map->parentWidget();
  }
  rows_.clear();
  for (std::size_t k = 0; k < count; ++k) {
    auto* frame = new QWidget(list_);
    frame->setObjectName(QStringLiteral("boardCamera%1").arg(k));
    const auto label = [&](const char* name) {
      auto* made = new QLabel(frame);
      made->setObjectName(QLatin1String(name) + QString::number(k));
      made->setWordWrap(true);
      return made;
    };
    Row row{new BoardMap(frame),    label("describedBoard"), label("boardAdvice"),
            label("boardAccuracy"), label("boardSharpness"), new QProgressBar(frame)};
    row.map->setObjectName(QStringLiteral("boardMap%1").arg(k));
    row.holdProgress->setObjectName(QStringLiteral("boardHeld%1").arg(k));
    row.holdProgress->setRange(0, kHeldSteps);
    row.holdProgress->setTextVisible(false);
    row.holdProgress->setMaximumHeight(8);
    QFont bold = row.name->font();
    bold.setBold(true);
    row.name->setFont(bold);
    auto* text = new QVBoxLayout;
    text->setSpacing(3);
    for (QWidget* part : std::initializer_list<QWidget*>{row.name, row.advice, row.holdProgress,
                                                         row.accuracy, row.sharpness}) {
      text->addWidget(part);
    }
    text->addStretch(1);
    auto* line = new QHBoxLayout(frame);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(row.map, 0, Qt::AlignTop);
    line->addLayout(text, 1);
    grid_->addWidget(frame, static_cast<int>(k), 0, 1, 2);
    rows_.push_back(row);
  }
}

void BoardLive::fillRow(const Row& row, const BoardGuideState& state, std::size_t camera) {
  const auto& of = state.cameras[camera];
  const bool lens = state.phase == BoardGuideState::Phase::Lenses ||
                    (!calibrator_.guideRequest().goal.estimatesPoses &&
                     calibrator_.guideRequest().goal.estimatesLenses);
  row.map->setCamera(of, lens);
  row.name->setText(calibrator_.nameOf(camera));
  row.advice->setText(lens ? adviceText(of) : visibilityText(of));
  row.accuracy->setText(lens ? lensAccuracyText(of, calibrator_.guideRequest().lensGuidance)
                             : positionAccuracyText(of));
  row.sharpness->setText(sharpnessText(of, calibrator_.guideRequest().lensGuidance));
  const double held = lens           ? of.lensGuidance.holdProgress
                      : of.detection ? state.rigGuidance.holdProgress
                                     : 0.0;
  row.holdProgress->setValue(static_cast<int>(kHeldSteps * held));
  row.holdProgress->setAccessibleName(
      tr("Time for which the board was held still in front of %1").arg(calibrator_.nameOf(camera)));
  row.map->setAccessibleName(
      tr("Positions in which %1 saw the board").arg(calibrator_.nameOf(camera)));
  row.map->setToolTip(tr("Filled: image regions and tilts in which the board was already shown. "
                         "Orange: what to show next. Green: the board in the current image"));
}

void BoardLive::retranslateUi() {
  capture_->setText(tr("Capture now"));
  capture_->setToolTip(tr("Capture the board as it is shown now, even if it is not held still"));
  floor_->setText(tr("Set floor from board"));
  floor_->setToolTip(tr("Define the world coordinates with the board that lies on the floor now: X "
                        "along its rows, Y toward its upper edge, Z up from the floor"));
  next_->setText(tr("Next: positions"));
  next_->setToolTip(tr("Accept the current accuracy of the intrinsics; then show the board to "
                       "several cameras at once"));
  display_->setText(tr("Large display…"));
  display_->setToolTip(tr("Show what to do next in large letters that can be read from across the "
                          "room, with a sound for each captured view"));
  finish_->setText(tr("Calibrate with these views"));
  finish_->setToolTip(tr("Finish now with the views captured so far"));
  refresh();
}

void BoardLive::refresh() {
  const bool watching = calibrator_.isGuiding();
  const auto state = calibrator_.guideState();
  const bool places = state->phase == BoardGuideState::Phase::Poses;
  start_->setText(watching || calibrator_.hasCapturedViews() ? tr("Start over") : tr("Start"));
  start_->setToolTip(tr("Find the board in the live images and get guidance on what to show"));
  start_->setEnabled(!calibrator_.isComputing());
  capture_->setEnabled(watching);
  floor_->setVisible(calibrator_.guideRequest().goal.estimatesPoses);
  floor_->setEnabled(watching && places);
  next_->setVisible(calibrator_.guideRequest().goal.estimatesPoses &&
                    calibrator_.guideRequest().goal.estimatesLenses);
  next_->setEnabled(watching && !places);
  finish_->setEnabled(calibrator_.hasCapturedViews() && !calibrator_.isComputing() &&
                      !calibrator_.outcome());
  list_->setVisible(!state->cameras.empty());
  overall_->setVisible(watching);
  followGuide();
}

void BoardLive::followGuide() {
  const auto state = calibrator_.guideState();
  if (rows_.size() != state->cameras.size()) {
    makeRows(state->cameras.size());
  }
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    fillRow(rows_[k], *state, k);
  }
  overall_->setText(state->frame < 0 ? tr("Waiting for images. Check that the cameras are running.")
                    : state->phase == BoardGuideState::Phase::Poses
                        ? cameraPairText(calibrator_, state->rigGuidance)
                        : tr("Show the board to one camera after the other, following the "
                             "instructions for each."));
}

} // namespace dewpoint::ui
