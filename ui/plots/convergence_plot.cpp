// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/convergence_plot.h"

#include "core/session/snapshot.h"

#include <QEvent>
#include <QVBoxLayout>
#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace dewpoint {

namespace {

constexpr double kShownIterations = 2000.0;
constexpr double kLeastMm = 0.1; ///< a logarithmic axis has no zero

double millimetres(double metres) {
  return std::max(kLeastMm, metres * 1000.0);
}

} // namespace

ConvergencePlot::ConvergencePlot(QWidget* parent) : QWidget(parent), plot_(new QCustomPlot(this)) {
  setObjectName(QStringLiteral("convergencePlot"));
  plot_->setObjectName(QStringLiteral("convergencePlotCanvas"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(plot_);

  spread_ = plot_->addGraph();
  spread_->setName(tr("spread"));
  error_ = plot_->addGraph();
  error_->setName(tr("error against truth"));
  error_->removeFromLegend();
  plot_->xAxis->setLabel(tr("filter iteration"));
  plot_->yAxis->setLabel(tr("mm"));
  plot_->yAxis->setScaleType(QCPAxis::stLogarithmic);
  plot_->yAxis->setTicker(QSharedPointer<QCPAxisTickerLog>::create());
  plot_->yAxis->setNumberFormat(QStringLiteral("gb"));
  plot_->yAxis->setNumberPrecision(4);
  plot_->xAxis->setNumberFormat(QStringLiteral("f"));
  plot_->xAxis->setNumberPrecision(0);
  plot_->yAxis->setRange(1.0, 1000.0);
  plot_->xAxis->setRange(0.0, 100.0);
  plot_->legend->setVisible(true);
  plot_->legend->setBorderPen(Qt::NoPen);
  // One row above the curves, which therefore never run behind it.
  plot_->plotLayout()->insertRow(0);
  auto* row = new QCPLayoutGrid;
  plot_->plotLayout()->addElement(0, 0, row);
  row->addElement(0, 0, new QCPLayoutElement(plot_));
  row->addElement(0, 1, plot_->legend);
  row->setColumnStretchFactor(1, 0.001);
  plot_->plotLayout()->setRowStretchFactor(0, 0.001);
  plot_->plotLayout()->setRowSpacing(0);
  plot_->legend->setFillOrder(QCPLegend::foColumnsFirst);
  plot_->legend->setMargins(QMargins(8, 4, 8, 0));
  applyPalette();
}

void ConvergencePlot::append(const std::vector<IterationRecord>& records) {
  bool any = false;
  for (const IterationRecord& record : records) {
    if (record.target != 0) {
      continue;
    }
    any = true;
    const auto iteration = static_cast<double>(record.iteration);
    spread_->addData(iteration, millimetres(record.spread));
    if (record.error >= 0.0) {
      error_->addData(iteration, millimetres(record.error));
    }
  }
  if (!any) {
    return;
  }
  const double last = (spread_->data()->constEnd() - 1)->key;
  spread_->data()->removeBefore(last - kShownIterations);
  error_->data()->removeBefore(last - kShownIterations);
  if (!error_->data()->isEmpty() && plot_->legend->itemWithPlottable(error_) == nullptr) {
    error_->addToLegend();
  }
  fitAxes();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

void ConvergencePlot::clear() {
  spread_->data()->clear();
  error_->data()->clear();
  plot_->replot(QCustomPlot::rpQueuedReplot);
}

int ConvergencePlot::shownIterations() const {
  return spread_->dataCount();
}

void ConvergencePlot::fitAxes() {
  const double first = spread_->data()->constBegin()->key;
  const double last = (spread_->data()->constEnd() - 1)->key;
  plot_->xAxis->setRange(first, std::max(last, first + 60.0));
  bool found = false;
  QCPRange range = spread_->getValueRange(found);
  bool errorFound = false;
  const QCPRange errors = error_->getValueRange(errorFound);
  if (errorFound) {
    range.expand(errors);
  }
  // Whole decades: the axis stays put while the curve moves.
  plot_->yAxis->setRange(std::pow(10.0, std::floor(std::log10(range.lower))),
                         std::pow(10.0, std::floor(std::log10(range.upper)) + 1.0));
}

void ConvergencePlot::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    applyPalette();
    plot_->replot(QCustomPlot::rpQueuedReplot);
  }
}

void ConvergencePlot::applyPalette() {
  const QColor text = palette().color(QPalette::WindowText);
  const QColor grid = palette().color(QPalette::Mid);
  const bool dark = palette().color(QPalette::Window).lightness() < 128;
  plot_->setBackground(palette().color(QPalette::Base));
  for (QCPAxis* axis : {plot_->xAxis, plot_->yAxis}) {
    axis->setBasePen(QPen(grid));
    axis->setTickPen(QPen(grid));
    axis->setSubTickPen(Qt::NoPen);
    axis->setTickLabelColor(text);
    axis->setLabelColor(text);
    axis->setTickLabelFont(font());
    axis->setLabelFont(font());
    axis->grid()->setPen(QPen(grid, 1.0, Qt::DotLine));
    axis->grid()->setZeroLinePen(Qt::NoPen);
  }
  QColor ground = palette().color(QPalette::Base);
  ground.setAlpha(210);
  plot_->legend->setBrush(ground);
  plot_->legend->setTextColor(text);
  plot_->legend->setFont(font());
  spread_->setPen(QPen(QColor(dark ? "#56b4e9" : "#0072b2"), 1.6));
  error_->setPen(QPen(QColor(dark ? "#e69f00" : "#c05a00"), 1.6));
}

} // namespace dewpoint
