// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/run_details.h"

#include "core/base/units.h"
#include "core/session/snapshot/snapshot.h"
#include "ui/text/quantity_text.h"
#include "ui/text/retranslation.h"

#include <QGridLayout>
#include <QLabel>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

namespace {

constexpr double kMegabyte = 1024.0 * 1024.0;
const QString kUnknown(QStringLiteral("–"));

QString latencyText(const Latency& latency) {
  return latency.longest <= 0.0 ? kUnknown
                                : RunDetails::tr("median %1, 99 % at most %2, longest %3")
                                      .arg(millisecondsText(inMilliseconds(latency.median)),
                                           millisecondsText(inMilliseconds(latency.p99)),
                                           millisecondsText(inMilliseconds(latency.longest)));
}

/// A number of the durations of a stage, its median or its 99th percentile.
QString stageText(const Latency& stage, double Latency::*number) {
  return stage.longest <= 0.0 ? kUnknown : millisecondsText(inMilliseconds(stage.*number));
}

/// One such number of each stage, in a text with five placeholders.
QString stagesText(const QString& text, const LiveLatency& live, double Latency::*number) {
  return text.arg(stageText(live.capture, number), stageText(live.decode, number),
                  stageText(live.wait, number), stageText(live.compute, number),
                  stageText(live.draw, number));
}

/// Of live cameras: median and 99th percentile from light to estimate, and of its parts.
QString liveLatencyText(const LiveLatency& live) {
  if (live.total.longest <= 0.0) {
    return kUnknown;
  }
  QString text = RunDetails::tr("median %1, 99th percentile %2")
                     .arg(millisecondsText(inMilliseconds(live.total.median)),
                          millisecondsText(inMilliseconds(live.total.p99)));
  text +=
      QLatin1Char('\n') +
      stagesText(RunDetails::tr("Median: capture %1 · decode %2 · wait %3 · compute %4 · draw %5"),
                 live, &Latency::median);
  text +=
      QLatin1Char('\n') +
      stagesText(RunDetails::tr(
                     "99th percentile: capture %1 · decode %2 · wait %3 · compute %4 · draw %5"),
                 live, &Latency::p99);
  if (live.imageCounts[static_cast<std::size_t>(TimeOrigin::Arrival)] > 0) {
    text += QLatin1Char('\n') + RunDetails::tr("If a camera does not report capture times, the "
                                               "time is counted from the arrival of its image");
  }
  return text;
}

QString budgetText(const BudgetStatistics& budget) {
  if (budget.budgetMilliseconds <= 0.0 || budget.iterationCount == 0) {
    return RunDetails::tr("not set");
  }
  const double kept = 1.0 - static_cast<double>(budget.lateIterationCount) /
                                static_cast<double>(budget.iterationCount);
  return RunDetails::tr("%1 (met by %2 % of the iterations of this run)")
      .arg(millisecondsText(budget.budgetMilliseconds), percentNumber(kept, 1));
}

} // namespace

RunDetails::RunDetails(QWidget* parent) : QFrame(parent, Qt::Popup), rows_(new QGridLayout(this)) {
  setObjectName(QStringLiteral("statusDetails"));
  setFrameShape(QFrame::StyledPanel);
  rows_->setContentsMargins(12, 10, 12, 10);
  rows_->setHorizontalSpacing(16);
  rows_->setVerticalSpacing(4);
  for (const auto& [label, name] :
       std::initializer_list<std::pair<QLabel**, const char*>>{{&time_, "statusTime"},
                                                               {&latency_, "statusLatency"},
                                                               {&liveLatency_, "statusLiveLatency"},
                                                               {&budget_, "statusBudget"},
                                                               {&sampleSize_, "statusSampleSize"},
                                                               {&iterations_, "statusIterations"},
                                                               {&dropped_, "statusDropped"},
                                                               {&seed_, "statusSeed"},
                                                               {&history_, "statusHistory"}}) {
    *label = row(name);
  }
  onRetranslate(this, [this] { retranslateUi(); });
  setSnapshot(nullptr, nullptr);
}

QLabel* RunDetails::row(const char* name) {
  auto* label = new QLabel(this);
  label->setObjectName(QLatin1String(name));
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* heading = new QLabel(this);
  heading->setForegroundRole(QPalette::PlaceholderText);
  names_[label] = heading;
  const int at = rows_->rowCount();
  rows_->addWidget(heading, at, 0);
  rows_->addWidget(label, at, 1);
  return label;
}

void RunDetails::retranslateUi() {
  names_[time_]->setText(tr("Median time per iteration"));
  names_[latency_]->setText(tr("Time from camera image to estimate"));
  names_[liveLatency_]->setText(tr("Time from light to estimate"));
  names_[budget_]->setText(tr("Time budget per iteration"));
  names_[sampleSize_]->setText(tr("Effective sample size"));
  names_[iterations_]->setText(tr("Iterations since the start"));
  names_[dropped_]->setText(tr("Frames skipped"));
  names_[seed_]->setText(tr("Random seed"));
  names_[history_]->setText(tr("Memory for earlier frames"));
  for (QLabel* label : {names_[history_], history_}) {
    label->setToolTip(tr("Memory for going back to earlier frames: images, particles and saved "
                         "states of the method. When it is full, only the estimates of older "
                         "frames are kept."));
  }
}

void RunDetails::setSnapshot(const TrackSnapshotPtr& snapshot, const TargetSnapshot* target) {
  if (snapshot != nullptr) {
    refresh(*snapshot, target);
    return;
  }
  for (const auto& [label, name] : names_) {
    label->setText(kUnknown);
  }
}

void RunDetails::refresh(const TrackSnapshot& snapshot, const TargetSnapshot* target) {
  time_->setText(durationText(snapshot.microsecondsPerIteration));
  latency_->setText(latencyText(snapshot.latency));
  liveLatency_->setText(liveLatencyText(snapshot.liveLatency));
  budget_->setText(budgetText(snapshot.budget));
  const int particles = target != nullptr ? particleCountOf(target->estimate) : 0;
  sampleSize_->setText(particles <= 0
                           ? kUnknown
                           : tr("%1 of %2 particles")
                                 .arg(numberText(effectiveSampleSizeOf(target->estimate), 0))
                                 .arg(particles));
  iterations_->setText(QString::number(snapshot.iterationCount));
  dropped_->setText(QString::number(snapshot.droppedFrameCount));
  seed_->setText(QString::number(snapshot.seed));
  history_->setText(
      tr("%1 of %2 MB")
          .arg(numberText(static_cast<double>(snapshot.history.memoryBytes) / kMegabyte, 0),
               numberText(static_cast<double>(snapshot.history.maxMemoryBytes) / kMegabyte, 0)));
}

void RunDetails::openAbove(const QWidget* widget) {
  adjustSize();
  const QPoint corner = widget->mapToGlobal(QPoint(widget->width(), 0));
  move(corner - QPoint(width(), height() + 4));
  show();
}

} // namespace dewpoint::ui
