// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/status_bar_panel.h"

#include "core/base/overloaded.h"
#include "core/session/snapshot/snapshot.h"
#include "ui/document/method_presentation.h"
#include "ui/mainwindow/run_details.h"
#include "ui/text/people_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/reason_text.h"
#include "ui/text/retranslation.h"
#include "ui/text/tracking_state_text.h"
#include "ui/widgets/elided_label.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QResizeEvent>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

namespace {

constexpr int kStatusSpacing = 20;
constexpr int kWidestName = 220;  ///< of a target; a longer one is cut
constexpr int kLeastReason = 160; ///< pixels; less of a reason cannot be understood

/// Digits keep their places whether there is a minus before them or not.
QString padded(const QString& text, double meters) {
  return meters < 0.0 ? text : QChar(0x2007) + text;
}

/// A coordinate of a position in the room.
QString placeNumber(double meters) {
  return padded(lengthNumber(meters, LengthScale::Meters, 3, NumberForm::Table), meters);
}

QString playWord(const TrackSnapshot& snapshot) {
  if (snapshot.rerun) {
    return StatusBarPanel::tr("tracking again");
  }
  if (snapshot.isPast && snapshot.state == PlayState::Paused) {
    return StatusBarPanel::tr("looking back");
  }
  switch (snapshot.state) {
  case PlayState::Playing:
    return StatusBarPanel::tr("playing");
  case PlayState::Paused:
    return StatusBarPanel::tr("paused");
  case PlayState::Ended:
    break;
  }
  return StatusBarPanel::tr("ended");
}

/// Why a target is not held, and what helps.
QString reasonOf(const TrackSnapshot& snapshot, const TargetSnapshot& target) {
  const auto ofCameras = [&] {
    return target.status == TargetStatus::Ambiguous
               ? StatusBarPanel::tr(
                     "other objects fit equally well: press X and drag the target to its position")
           : snapshot.family.isDefined(target.target)
               ? reasonText(target.cameraReports, cameraNames(snapshot))
               : StatusBarPanel::tr("click the object or drag a box around it");
  };
  return std::visit(Overloaded{[&](const SphereEstimate&) { return ofCameras(); },
                               [](const BoxEstimate&) {
                                 return StatusBarPanel::tr("the box shows the expected position");
                               },
                               [&](const PersonEstimate&) { return ofCameras(); },
                               [&](const AbsentEstimate&) { return ofCameras(); }},
                    target.estimate);
}

} // namespace

StatusBarPanel::StatusBarPanel(QWidget* parent)
    : QWidget(parent), held_(nullptr), reason_(new ElidedLabel(this)), more_(new QToolButton(this)),
      details_(new RunDetails(this)) {
  setObjectName(QStringLiteral("statusFigures"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 2, 8, 2);
  layout->setSpacing(kStatusSpacing);
  held_ = addValueLabel("statusHeld");
  QFont bold = held_->font();
  bold.setWeight(QFont::DemiBold);
  held_->setFont(bold);
  position_ = addValueLabel("statusPosition");
  spread_ = addValueLabel("statusSpread");
  speed_ = addValueLabel("statusSpeed");
  reason_->setObjectName(QStringLiteral("statusReason"));
  layout->addWidget(reason_, 1);
  playing_ = addValueLabel("statusPlaying");
  frame_ = addValueLabel("statusFrame");
  rate_ = addValueLabel("statusRate");
  for (QLabel* label : {playing_, frame_, rate_}) {
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  }
  frame_->setCursor(Qt::PointingHandCursor);
  frame_->installEventFilter(this);
  more_->setObjectName(QStringLiteral("statusMore"));
  more_->setAutoRaise(true);
  more_->setFocusPolicy(Qt::TabFocus);
  layout->addWidget(more_);
  connect(more_, &QToolButton::clicked, this, [this] { details_->openAbove(more_); });
  hideOrder_ = {more_, rate_, playing_, frame_, speed_, spread_, position_};
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  onRetranslate(this, [this] { retranslateUi(); });
}

void StatusBarPanel::retranslateUi() {
  const auto explain = [](QLabel* label, const QString& widest, const QString& hint) {
    label->setMinimumWidth(label->fontMetrics().horizontalAdvance(widest) + 8);
    label->setToolTip(hint);
  };
  explain(playing_, tr("tracking again"),
          tr("State of the run: playing, paused, at the end, looking back at an earlier frame, or "
             "tracking again"));
  explain(frame_, tr("frame %1 / %2").arg("0000", "0000"),
          tr("Number of the frame shown, and number of all frames. Click to go to another frame"));
  explain(rate_, frameRateText(888.8), tr("Frames tracked per second, while playing"));
  explain(spread_, tr("± %1").arg("0000 mm"),
          tr("Uncertainty of the position: the standard deviations in x, y and z combined. The "
             "plots show each of the three"));
  explain(speed_, speedText(88.88), tr("Speed of the target in the room"));
  explain(position_, tr("x %1  y %2  z %3").arg("−00.000", "−00.000", "−00.000 m"),
          tr("Estimated position of the target in the room"));
  explain(held_, trackingStateText(TrackingState::Searching),
          tr("Tracking: the cameras confirm the estimate. Ambiguous: another object fits about as "
             "well. Lost: not tracked for more than a second."));
  more_->setText(tr("Details"));
  more_->setToolTip(tr("Timing, particles and memory used"));
  refresh();
  hideOverflow();
}

QLabel* StatusBarPanel::addValueLabel(const char* name) {
  auto* label = new QLabel(this);
  label->setObjectName(QLatin1String(name));
  label->setTextFormat(Qt::PlainText);
  layout()->addWidget(label);
  return label;
}

void StatusBarPanel::clear() {
  stateText_.clear();
  state_ = TrackingState::NoImages;
  reason_->setFullText({});
  for (QLabel* label : {playing_, frame_, rate_}) {
    label->clear();
  }
  clearEstimate();
  motion_.clear();
  details_->setSnapshot(nullptr, nullptr);
  applyPalette();
}

void StatusBarPanel::setSnapshot(const TrackSnapshotPtr& snapshot) {
  snapshot_ = snapshot;
  refresh();
}

void StatusBarPanel::setTarget(int target) {
  target_ = target;
  if (snapshot_) {
    refresh();
  }
}

void StatusBarPanel::refresh() {
  if (!snapshot_) {
    clear();
    return;
  }
  const TrackSnapshot& snapshot = *snapshot_;
  playing_->setText(playWord(snapshot));
  const QString frame = frameNumberText(snapshot.frame);
  frame_->setText(snapshot.frameCount ? tr("frame %1 / %2").arg(frame).arg(*snapshot.frameCount)
                                      : tr("frame %1").arg(frame));
  // While nothing is tracked, the rate of the last frames says nothing about this one.
  const bool isTracking = snapshot.state == PlayState::Playing && !snapshot.isPast;
  rate_->setText(isTracking && snapshot.framesPerSecond > 0.0
                     ? frameRateText(snapshot.framesPerSecond)
                     : QString());
  const TargetSnapshot* target = targetToExplain(snapshot, target_);
  if (target != nullptr) {
    std::visit(Overloaded{[&](const SphereEstimate&) { showPosition(*target); },
                          [&](const BoxEstimate& box) { showBox(box); },
                          [&](const PersonEstimate&) { showPosition(*target); },
                          [&](const AbsentEstimate&) { clearEstimate(); }},
               target->estimate);
  } else {
    clearEstimate();
  }
  details_->setSnapshot(snapshot_, target);
  const bool several = snapshot.targets.size() > 1;
  state_ = target != nullptr && several && snapshot.isTracked ? trackingState(*target)
                                                              : trackingState(snapshot);
  name_ = several ? QString::fromStdString(target->target.name) : QString();
  const bool mustSay = target != nullptr && target->status != TargetStatus::Held;
  stateText_.clear();
  if (presentationOf(snapshot).listsPeople && target_ < 0) { // nobody in particular
    state_ = trackingState(snapshot);
    name_.clear();
    const QString there = numberText(peopleCount(snapshot), 0);
    stateText_ = state_ == TrackingState::Held        ? tr("● people: %1").arg(there)
                 : state_ == TrackingState::Searching ? tr("○ people: %1, searching").arg(there)
                                                      : QString();
  }
  reason_->setFullText(mustSay ? reasonOf(snapshot, *target) : QString());
  applyPalette(); // which makes them fit
}

void StatusBarPanel::showPosition(const TargetSnapshot& target) {
  const auto position = positionOf(target.estimate);
  const int particles = particleCountOf(target.estimate);
  if (!position || particles <= 0) {
    clearEstimate();
    return;
  }
  spread_->setText(tr("± %1").arg(lengthText(spreadOf(position->covariance))));
  const double z = position->mean.z();
  position_->setText(tr("x %1  y %2  z %3")
                         .arg(placeNumber(position->mean.x()), placeNumber(position->mean.y()),
                              padded(lengthText(z, LengthScale::Meters, 3, NumberForm::Table), z)));
  motion_.add(*snapshot_, target);
  const auto speed = motion_.metersPerSecond();
  speed_->setText(speed ? speedText(*speed) : QString());
}

void StatusBarPanel::clearEstimate() {
  for (QLabel* label : {position_, spread_, speed_}) {
    label->clear();
  }
}

void StatusBarPanel::showBox(const BoxEstimate& estimate) {
  speed_->clear();
  spread_->setText(tr("± %1").arg(pixelText(estimate.spreadPixels)));
  const Eigen::Vector2d center = estimate.box.center();
  position_->setText(tr("x %1  y %2  %3 × %4")
                         .arg(numberText(center.x(), 1), numberText(center.y(), 1),
                              numberText(estimate.box.width, 0),
                              pixelText(estimate.box.height, 0)));
}

bool StatusBarPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == frame_ && event->type() == QEvent::MouseButtonPress &&
      static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton && snapshot_ != nullptr) {
    Q_EMIT frameClicked();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void StatusBarPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    applyPalette();
  }
}

void StatusBarPanel::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  hideOverflow();
}

QSize StatusBarPanel::minimumSizeHint() const {
  return {120, layout()->minimumSize().height()};
}

void StatusBarPanel::hideOverflow() {
  const QMargins margins = layout()->contentsMargins();
  const auto widthOf = [](const QWidget* part) {
    return std::max(part->minimumWidth(), part->sizeHint().width()) + kStatusSpacing;
  };
  // An empty value before a reason leaves it its room.
  const QString reason = reason_->fullText();
  const auto isSpare = [this, &reason](const QWidget* part) {
    const auto isEmpty = [part](const QLabel* label) {
      return part == label && label->text().isEmpty();
    };
    return !reason.isEmpty() && (isEmpty(position_) || isEmpty(spread_) || isEmpty(speed_));
  };
  int needed = margins.left() + margins.right() + widthOf(held_);
  for (const QWidget* part : hideOrder_) {
    needed += isSpare(part) ? 0 : widthOf(part);
  }
  if (!reason.isEmpty()) {
    needed += std::min(kLeastReason, fontMetrics().horizontalAdvance(reason)) + kStatusSpacing;
  }
  for (QWidget* part : hideOrder_) {
    const bool fits = needed <= width();
    const bool isShown = fits && !isSpare(part);
    if (part->isHidden() == isShown) {
      part->setVisible(isShown);
    }
    needed -= fits || isSpare(part) ? 0 : widthOf(part);
  }
}

void StatusBarPanel::applyPalette() {
  const QString name = fontMetrics().elidedText(name_, Qt::ElideRight, kWidestName);
  held_->setText(!stateText_.isEmpty() ? stateText_
                 : name_.isEmpty()     ? trackingStateText(state_)
                                   : QStringLiteral("%1: %2").arg(name, trackingStateText(state_)));
  // What follows stays where it is when the word becomes a shorter one.
  held_->setMinimumWidth(std::max(held_->minimumWidth(), held_->sizeHint().width()));
  QPalette colors = held_->palette();
  const QColor color = trackingStateColor(state_, palette());
  if (colors.color(QPalette::WindowText) != color) {
    colors.setColor(QPalette::WindowText, color);
    held_->setPalette(colors);
  }
  hideOverflow();
}

} // namespace dewpoint::ui
