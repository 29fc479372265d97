// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/quick_start.h"

#include "ui/help/overlay_legend.h"
#include "ui/style/theme.h"
#include "ui/text/retranslation.h"
#include "ui/text/tracking_state_text.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <array>

namespace dewpoint::ui {

namespace {

constexpr std::size_t kQuickStartSteps = 5;
constexpr int kTextWidth = 500;
constexpr QSize kQuickStartSize(576, 736);
constexpr std::array kStates{TrackingState::Held, TrackingState::Ambiguous,
                             TrackingState::Searching, TrackingState::Lost};

QString stateMeaning(TrackingState state) {
  switch (state) {
  case TrackingState::Held:
    return QuickStart::tr("The cameras confirm where the target is.");
  case TrackingState::Ambiguous:
    return QuickStart::tr(
        "Another object fits about as well. Press X and drag the target to its true position.");
  case TrackingState::Searching:
    return QuickStart::tr(
        "The target is not found yet, or has been out of sight for less than a second.");
  default:
    return QuickStart::tr(
        "The target has been out of sight for more than a second. The status bar shows why.");
  }
}

QString keyOf(const QAction* action) {
  return action->shortcut().toString(QKeySequence::NativeText);
}

} // namespace

QuickStart::QuickStart(const Actions& actions, QWidget* parent)
    : QDialog(parent), actions_(actions), legend_(new QPushButton(this)),
      manual_(new QPushButton(this)), close_(new QPushButton(this)) {
  setObjectName(QStringLiteral("quickStart"));
  auto* page = new QWidget;
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(20, 16, 20, 16);
  column->setSpacing(8);
  seenHeading_ = addHeading(column);
  seenText_ = addText(column);
  auto* rows = new QGridLayout;
  rows->setHorizontalSpacing(16);
  rows->setVerticalSpacing(8);
  OverlayLegend::addRows(
      rows, {LegendSign::Particles, LegendSign::Estimate, LegendSign::Belief, LegendSign::Truth},
      page);
  column->addLayout(rows);
  column->addSpacing(8);
  stateHeading_ = addHeading(column);
  addStates(column);
  column->addSpacing(8);
  beginHeading_ = addHeading(column);
  for (std::size_t step = 0; step < kQuickStartSteps; ++step) {
    steps_.push_back(addText(column));
    steps_.back()->setObjectName(QStringLiteral("quickStartStep%1").arg(step + 1));
  }
  column->addStretch();
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(page);
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(legend_, QDialogButtonBox::ActionRole);
  buttons->addButton(manual_, QDialogButtonBox::ActionRole);
  buttons->addButton(close_, QDialogButtonBox::RejectRole);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(legend_, &QPushButton::clicked, actions_.legend, &QAction::trigger);
  connect(manual_, &QPushButton::clicked, actions_.manual, &QAction::trigger);
  close_->setDefault(true);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 12);
  all->addWidget(scroll);
  auto* bottom = new QHBoxLayout;
  bottom->setContentsMargins(20, 0, 20, 0);
  bottom->addWidget(buttons);
  all->addLayout(bottom);
  onRetranslate(this, [this] { retranslateUi(); });
  resize(kQuickStartSize.boundedTo(parent->size()));
}

QLabel* QuickStart::addHeading(QVBoxLayout* column) {
  auto* label = addText(column);
  QFont font = label->font();
  font.setPointSizeF(font.pointSizeF() * 1.25);
  font.setWeight(QFont::DemiBold);
  label->setFont(font);
  return label;
}

QLabel* QuickStart::addText(QVBoxLayout* column) {
  auto* label = new QLabel(this);
  label->setWordWrap(true);
  label->setFixedWidth(kTextWidth);
  column->addWidget(label);
  return label;
}

void QuickStart::addStates(QVBoxLayout* column) {
  auto* rows = new QGridLayout;
  rows->setHorizontalSpacing(16);
  rows->setVerticalSpacing(4);
  rows->setColumnStretch(1, 1);
  for (const TrackingState state : kStates) {
    auto* word = new QLabel(this);
    auto* text = new QLabel(this);
    text->setWordWrap(true);
    QFont font = word->font();
    font.setWeight(QFont::DemiBold);
    word->setFont(font);
    const int row = rows->rowCount();
    rows->addWidget(word, row, 0, Qt::AlignTop);
    rows->addWidget(text, row, 1);
    stateWords_.push_back(word);
    stateTexts_.push_back(text);
    word->setObjectName(QStringLiteral("quickStartState%1").arg(static_cast<int>(state)));
  }
  column->addLayout(rows);
}

void QuickStart::retranslateUi() {
  setWindowTitle(tr("Quick start – Dewpoint"));
  seenHeading_->setText(tr("What you see"));
  seenText_->setText(tr("Each camera view shows its image with the estimates drawn over it. The "
                        "bird's-eye view shows the estimates in the room."));
  stateHeading_->setText(tr("State of a target"));
  beginHeading_->setText(tr("How to start"));
  const std::array<QString, kQuickStartSteps> steps{
      tr("1.  Open one video per camera, or connect cameras: File › New project (%1). Or try the "
         "demo first.")
          .arg(keyOf(actions_.openProject)),
      tr("2.  Calibrate the cameras: Calibration › Calibrate (%1) guides you through it. Without "
         "a calibration, targets are tracked only in the images.")
          .arg(keyOf(actions_.calibrate)),
      tr("3.  Click the object to track in any image. Its color is learned in all cameras, and "
         "tracking starts."),
      tr("4.  Press %1 to play or pause. Drag along the timeline to look back: all views then show "
         "that frame as it was tracked.")
          .arg(keyOf(actions_.play)),
      tr("5.  Export the trajectory: File › Export trajectory (%1).")
          .arg(keyOf(actions_.exportTrajectory))};
  for (std::size_t step = 0; step < kQuickStartSteps; ++step) {
    steps_[step]->setText(steps[step]);
  }
  legend_->setText(tr("Show legend…"));
  legend_->setToolTip(tr("Open the legend of everything drawn over the images"));
  manual_->setText(tr("Manual…"));
  manual_->setToolTip(tr("Open the manual"));
  close_->setText(tr("Close"));
  close_->setToolTip(tr("Close this window"));
  showStates();
}

void QuickStart::showStates() {
  for (std::size_t k = 0; k < kStates.size(); ++k) {
    stateWords_[k]->setText(trackingStateText(kStates[k]));
    stateTexts_[k]->setText(stateMeaning(kStates[k]));
    QPalette colors = stateWords_[k]->palette();
    const QColor color = trackingStateColor(kStates[k], palette());
    if (colors.color(QPalette::WindowText) != color) {
      colors.setColor(QPalette::WindowText, color);
      stateWords_[k]->setPalette(colors);
    }
  }
}

void QuickStart::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && !stateWords_.empty()) {
    showStates();
  }
}

} // namespace dewpoint::ui
