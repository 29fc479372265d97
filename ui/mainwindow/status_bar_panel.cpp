// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/status_bar_panel.h"

#include "core/base/overloaded.h"
#include "core/session/run/snapshot.h"
#include "ui/document/method_presentation.h"
#include "ui/text/hold_text.h"
#include "ui/text/people_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/reason_text.h"
#include "ui/text/retranslation.h"
#include "ui/widgets/elided_label.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::ui {

namespace {

QString timeHint(const Latency& latency) {
  const QString hint = StatusBarPanel::tr("Median time of one filter iteration");
  if (latency.longest <= 0.0) {
    return hint;
  }
  return hint + QLatin1Char('\n') +
         StatusBarPanel::tr(
             "From a frame to its estimate: median %1, 99 of 100 within %2, longest %3")
             .arg(millisecondsText(1000.0 * latency.median), millisecondsText(1000.0 * latency.p99),
                  millisecondsText(1000.0 * latency.longest));
}

QString sampleHint(const BudgetFigures& budget) {
  const QString hint = StatusBarPanel::tr(
      "Effective sample size, of all particles. Method “dewpoint” uses as many particles as it "
      "needs and as the time budget allows.");
  if (budget.milliseconds <= 0.0 || budget.iterations == 0) {
    return hint + QLatin1Char('\n') + StatusBarPanel::tr("No time budget is set.");
  }
  const double kept =
      1.0 - static_cast<double>(budget.late) / static_cast<double>(budget.iterations);
  return hint + QLatin1Char('\n') +
         StatusBarPanel::tr("Time budget %1: kept in %2 % of the iterations of this run")
             .arg(millisecondsText(budget.milliseconds), percentText(kept, 1));
}

QString playWord(const TrackSnapshot& snapshot) {
  if (snapshot.rerun) {
    return StatusBarPanel::tr("tracking again");
  }
  if (snapshot.past && snapshot.state == PlayState::Paused) {
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
               ? StatusBarPanel::tr("others fit as well: press X, drag the target")
           : snapshot.family.isDefined(target.target)
               ? reasonText(target.reasons, cameraNames(snapshot))
               : StatusBarPanel::tr("click it or drag a box around it");
  };
  return std::visit(Overloaded{[&](const SphereEstimate&) { return ofCameras(); },
                               [](const BoxEstimate&) {
                                 return StatusBarPanel::tr("held where it is thought to be");
                               },
                               [&](const PersonEstimate&) { return ofCameras(); },
                               [&](const AbsentEstimate&) { return ofCameras(); }},
                    target.estimate);
}

} // namespace

StatusBarPanel::StatusBarPanel(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("statusFigures"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 2, 8, 2);
  layout->setSpacing(20);
  for (const auto& [label, name] :
       std::initializer_list<std::pair<QLabel**, const char*>>{{&playing_, "statusPlaying"},
                                                               {&frame_, "statusFrame"},
                                                               {&rate_, "statusRate"},
                                                               {&time_, "statusTime"},
                                                               {&sampleSize_, "statusSampleSize"},
                                                               {&spread_, "statusSpread"},
                                                               {&position_, "statusPosition"}}) {
    *label = figure(name);
  }
  layout->addStretch();
  reason_ = new ElidedLabel(this);
  reason_->setObjectName(QStringLiteral("statusReason"));
  layout->addWidget(reason_);
  reason_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  layout->setStretchFactor(reason_, 4);
  held_ = figure("statusHeld");
  QFont bold = held_->font();
  bold.setWeight(QFont::DemiBold);
  held_->setFont(bold);
  held_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  onRetranslate(this, [this] { retranslateUi(); });
}

void StatusBarPanel::retranslateUi() {
  const auto explain = [](QLabel* label, const QString& widest, const QString& hint) {
    label->setMinimumWidth(label->fontMetrics().horizontalAdvance(widest) + 8);
    label->setToolTip(hint);
  };
  explain(
      playing_, tr("tracking again"),
      tr("Playing, paused, at the end, looking back at an earlier moment, or tracking it again"));
  explain(frame_, tr("frame 0000 / 0000"), tr("Frame shown, of all frames"));
  explain(rate_, tr("%1 /s").arg("0000.0"), tr("Frames tracked per second"));
  explain(time_, tr("%1 per iteration").arg("0000 µs"), timeHint({}));
  explain(sampleSize_, tr("ESS %1 / %2").arg("0000", "0000"), sampleHint({}));
  explain(spread_, tr("spread %1").arg("0000 mm"),
          tr("Root mean square distance of the particles to their mean"));
  explain(position_, QStringLiteral("x −00.000  y −00.000  z −00.000 m"),
          tr("Estimated position of the target in the room"));
  explain(held_, holdText(HoldState::Searching),
          tr("Held: the cameras confirm the estimate. Ambiguous: something else fits about as "
             "well. Lost: not held for a second."));
  refresh();
}

QLabel* StatusBarPanel::figure(const char* name) {
  auto* label = new QLabel(this);
  label->setObjectName(QLatin1String(name));
  layout()->addWidget(label);
  return label;
}

void StatusBarPanel::clear() {
  stateText_.clear();
  state_ = HoldState::NoImages;
  reason_->setFullText({});
  for (QLabel* label : {playing_, frame_, rate_, time_, sampleSize_, spread_, position_}) {
    label->clear();
  }
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
  const QString frame = QString::number(snapshot.frame + 1); // people count from 1
  frame_->setText(snapshot.frameCount ? tr("frame %1 / %2").arg(frame).arg(*snapshot.frameCount)
                                      : tr("frame %1").arg(frame));
  rate_->setText(tr("%1 /s").arg(numberText(snapshot.framesPerSecond, 1)));
  time_->setText(tr("%1 per iteration").arg(durationText(snapshot.microsecondsPerIteration)));
  time_->setToolTip(timeHint(snapshot.latency));
  const TargetSnapshot* target = targetToExplain(snapshot, target_);
  if (target != nullptr) {
    std::visit(Overloaded{[&](const SphereEstimate&) { showPlace(*target); },
                          [&](const BoxEstimate& box) { showBox(box); },
                          [&](const PersonEstimate&) { showPlace(*target); },
                          [&](const AbsentEstimate&) { clearBelief(); }},
               target->estimate);
  } else {
    clearBelief();
  }
  const bool several = snapshot.targets.size() > 1;
  state_ =
      target != nullptr && several && snapshot.tracked ? holdState(*target) : holdState(snapshot);
  name_ = several ? QString::fromStdString(target->target.name) : QString();
  const bool mustSay = target != nullptr && target->status != TargetStatus::Held;
  stateText_.clear();
  if (presentationOf(snapshot).countsPeople && target_ < 0) { // nobody in particular
    state_ = holdState(snapshot);
    name_.clear();
    const QString there = numberText(peopleThere(snapshot), 0);
    stateText_ = state_ == HoldState::Held        ? tr("● people: %1").arg(there)
                 : state_ == HoldState::Searching ? tr("○ people: %1, searching").arg(there)
                                                  : QString();
  }
  reason_->setFullText(mustSay ? reasonOf(snapshot, *target) : QString());
  applyPalette();
}

void StatusBarPanel::showPlace(const TargetSnapshot& target) {
  const auto position = positionOf(target.estimate);
  const int particles = particleCountOf(target.estimate);
  if (!position || particles <= 0) {
    clearBelief();
    return;
  }
  sampleSize_->setToolTip(sampleHint(snapshot_->budget));
  sampleSize_->setText(
      tr("ESS %1 / %2").arg(numberText(effectiveSampleSizeOf(target.estimate), 0)).arg(particles));
  spread_->setText(tr("spread %1").arg(lengthText(std::sqrt(position->covariance.trace()))));
  position_->setText(tr("x %1  y %2  z %3")
                         .arg(lengthNumber(position->mean.x(), LengthScale::Meters, 3),
                              lengthNumber(position->mean.y(), LengthScale::Meters, 3),
                              lengthText(position->mean.z(), LengthScale::Meters, 3)));
}

void StatusBarPanel::clearBelief() {
  for (QLabel* label : {sampleSize_, spread_, position_}) {
    label->clear();
  }
}

void StatusBarPanel::showBox(const BoxEstimate& estimate) {
  sampleSize_->setToolTip(tr("Effective sample size, of all particles"));
  sampleSize_->setText(tr("ESS %1 / %2")
                           .arg(numberText(estimate.effectiveSampleSize, 0))
                           .arg(estimate.particleCount));
  spread_->setText(tr("spread %1").arg(pixelText(estimate.spread)));
  const Eigen::Vector2d center = estimate.box.center();
  position_->setText(tr("x %1  y %2  %3 × %4")
                         .arg(numberText(center.x(), 1), numberText(center.y(), 1),
                              numberText(estimate.box.width, 0),
                              pixelText(estimate.box.height, 0)));
}

void StatusBarPanel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    applyPalette();
  }
}

void StatusBarPanel::applyPalette() {
  held_->setText(!stateText_.isEmpty() ? stateText_
                 : name_.isEmpty()     ? holdText(state_)
                                       : QStringLiteral("%1: %2").arg(name_, holdText(state_)));
  QPalette colors = held_->palette();
  const QColor color = holdColor(state_, palette());
  if (colors.color(QPalette::WindowText) != color) {
    colors.setColor(QPalette::WindowText, color);
    held_->setPalette(colors);
  }
}

} // namespace dewpoint::ui
