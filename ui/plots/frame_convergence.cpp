// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/frame_convergence.h"

#include "ui/plots/plot_stack.h"
#include "ui/plots/run_plots.h"
#include "ui/text/quantity_text.h"
#include "ui/text/retranslation.h"

#include <QCoreApplication>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace dewpoint::ui {

namespace {

constexpr int kConvergenceWidth = 220;
constexpr std::size_t kRowsBefore = 12; ///< that are looked at for a frame of several iterations
constexpr int kLeastIterations = 9;     ///< of the axis, beyond the first

class Convergence {
  Q_DECLARE_TR_FUNCTIONS(Convergence)
};

} // namespace

std::pair<std::size_t, std::size_t> rowsOfFrame(const PlotSeries& run, std::int64_t frame) {
  const auto last = run.rowAtFrame(frame);
  if (!last) {
    return {0, 0};
  }
  std::size_t first = *last;
  while (first > 0 && run.row(first - 1).frame == run.row(*last).frame) {
    --first;
  }
  return {first, *last + 1};
}

bool hasSeveralIterationsPerFrame(const PlotSeries& run, std::int64_t frame) {
  const auto last = run.rowAtFrame(frame);
  if (!last) {
    return false;
  }
  for (std::size_t row = *last; row > 0 && *last - row < kRowsBefore; --row) {
    if (run.row(row).frame == run.row(row - 1).frame) {
      return true;
    }
  }
  return false;
}

FrameConvergence::FrameConvergence(QWidget* parent)
    : QWidget(parent), title_(new QLabel(this)), stack_(new PlotStack(this)) {
  setObjectName(QStringLiteral("frameConvergence"));
  setFixedWidth(kConvergenceWidth);
  title_->setObjectName(QStringLiteral("convergenceTitle"));
  title_->setContentsMargins(8, 2, 8, 0);
  stack_->setObjectName(QStringLiteral("convergenceStack"));
  stack_->setAttribute(Qt::WA_TransparentForMouseEvents); // it has one frame only
  stack_->setFocusPolicy(Qt::NoFocus);
  stack_->focusProxy()->setFocusPolicy(Qt::NoFocus);
  stack_->setCurvesOnly(true);
  stack_->setMinIterations(kLeastIterations);
  stack_->setShownPlots({QStringLiteral("convergence")});
  series_.reset(1);
  stack_->setSeries(&series_);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(title_);
  column->addWidget(stack_, 1);
  onRetranslate(this, [this] {
    declarePlot();
    updateTitle();
    setToolTip(Convergence::tr("Spread of the particles after each iteration on this frame. The "
                               "filter has converged where the curve levels off."));
  });
  hide();
}

void FrameConvergence::declarePlot() {
  stack_->setPlots({{QStringLiteral("convergence"),
                     Convergence::tr("Convergence"),
                     boxes_ ? PlotQuantity::Pixels : PlotQuantity::Length,
                     {{Convergence::tr("spread"), QStringLiteral("spread"), 0, 0}}}});
}

void FrameConvergence::updateTitle() {
  const QString unit = axisUnit(boxes_ ? PlotQuantity::Pixels : PlotQuantity::Length);
  title_->setText(Convergence::tr("Convergence in frame %1 (%2)", "number of a frame, unit")
                      .arg(frameNumberText(std::max<std::int64_t>(0, frame_)), unit));
}

void FrameConvergence::setTargetIsBox(bool boxes) {
  if (boxes != boxes_) {
    boxes_ = boxes;
    declarePlot();
    updateTitle();
  }
}

void FrameConvergence::showFrame(const PlotSeries& run, std::optional<std::int64_t> frame) {
  if (run.size() == 0) {
    series_.reset(1);
    hide();
    return;
  }
  const std::int64_t wanted = frame.value_or(run.row(run.size() - 1).frame);
  if (!hasSeveralIterationsPerFrame(run, wanted)) {
    series_.reset(1);
    hide();
    return;
  }
  const auto [first, last] = rowsOfFrame(run, wanted);
  series_.reset(1);
  for (std::size_t row = first; row < last; ++row) {
    const PlotSeries::Row& its = run.row(row);
    const auto spread = static_cast<float>(particleSpreadOf(run, row));
    series_.append({static_cast<std::int64_t>(row - first) + 1, its.frame, its.seconds},
                   std::span(&spread, 1));
  }
  frame_ = run.row(first).frame;
  updateTitle();
  setVisible(true);
  stack_->refresh();
}

} // namespace dewpoint::ui
