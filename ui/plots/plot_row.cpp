// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_row.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewpoint::ui {

namespace {

constexpr int kRowGap = 4;      ///< pixels between plots
constexpr int kMostColumns = 3; ///< of a readout
constexpr int kColumnGap = 12;

/// Ticks at powers of ten only, at most three of them: a row is low.
class DecadeTicker : public QCPAxisTicker {
protected:
  int getSubTickCount(double) override { return 0; }
  QVector<double> createTickVector(double, const QCPRange& range) override {
    const int first = static_cast<int>(std::ceil(std::log10(range.lower)));
    const int last = static_cast<int>(std::floor(std::log10(range.upper)));
    const int step = std::max(1, (last - first + 2) / 3);
    QVector<double> ticks;
    for (int decade = first; decade <= last; decade += step) {
      ticks << std::pow(10.0, decade);
    }
    return ticks;
  }
};

/// Labels with the decimals that the step between them has: 2.5, 5.0, 7.5.
class StepTicker : public QCPAxisTicker {
public:
  void setWhole(bool whole) { whole_ = whole; }

protected:
  double getTickStep(const QCPRange& range) override {
    const double step = QCPAxisTicker::getTickStep(range);
    if (!whole_ || step == std::round(step)) {
      return step;
    }
    return step < 1.0 ? 1.0 : 2.0 * step; // 2.5
  }
  QVector<double> createTickVector(double step, const QCPRange& range) override {
    step_ = step;
    return QCPAxisTicker::createTickVector(step, range);
  }
  QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override {
    constexpr double kLong = 1e5; // those and the tiniest are written with a power of ten
    constexpr int kMostDecimals = 4;
    const int decimals = decimalsOf(step_);
    if (std::abs(tick) >= kLong || decimals > kMostDecimals) {
      return QCPAxisTicker::getTickLabel(tick, locale, format, precision);
    }
    return locale.toString(std::abs(tick) < 1e-6 * step_ ? 0.0 : tick, 'f', decimals);
  }

private:
  static int decimalsOf(double step) {
    int decimals = 0;
    for (double scaled = step; std::abs(scaled - std::round(scaled)) > 1e-6 && decimals < 9;
         scaled *= 10.0) {
      ++decimals;
    }
    return decimals;
  }

  bool whole_ = false;
  double step_ = 1.0;
};

/// The next round number (1, 2, 5 times a power of ten) at or above a positive one.
double roundedUp(double value) {
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (value <= step * decade) {
      return step * decade;
    }
  }
  return 10.0 * decade;
}

} // namespace

PlotReadout::PlotReadout(QCustomPlot* plot, const PlotDeclaration& declaration)
    : QCPLayoutElement(plot), declaration_(declaration) {
  setLayer(QStringLiteral("cursor"));
}

int PlotReadout::widthFor(const std::vector<const PlotDeclaration*>& plots) {
  constexpr int kNarrow = 136; // one column of names and values
  constexpr int kWide = 264;   // several
  const bool narrow =
      std::ranges::all_of(plots, [](const auto* plot) { return plot->curves.size() <= 1; });
  return narrow ? kNarrow : kWide;
}

int PlotReadout::heightFor(const std::vector<const PlotDeclaration*>& plots, const QFont& font) {
  std::size_t lines = 4; // a curve needs some height to be read
  for (const PlotDeclaration* plot : plots) {
    lines = std::max(lines, 1 + (plot->curves.size() + kMostColumns - 1) / kMostColumns);
  }
  return static_cast<int>(lines) * QFontMetrics(font).height() + kRowGap;
}

void PlotReadout::setWidth(int width) {
  setMinimumSize(width, 0);
  setMaximumSize(width, QWIDGETSIZE_MAX);
}

QString PlotReadout::asText() const {
  QStringList parts;
  for (std::size_t curve = 0; curve < declaration_.curves.size(); ++curve) {
    const double value =
        curve < values_.size() ? values_[curve] : std::numeric_limits<double>::quiet_NaN();
    parts << QStringLiteral("%1 %2").arg(declaration_.curves[curve].name,
                                         quantityText(declaration_.quantity, value));
  }
  return parts.join(QStringLiteral(", "));
}

void PlotReadout::draw(QCPPainter* painter) {
  const QPalette& palette = mParentPlot->palette();
  const QColor text = palette.color(QPalette::WindowText);
  QFont font = mParentPlot->font();
  font.setPointSizeF(font.pointSizeF() * 0.92);
  const QFontMetrics metrics(font);
  const int line = metrics.height();
  QFont bold = font;
  bold.setWeight(QFont::DemiBold);
  painter->setFont(bold);
  painter->setPen(text);
  QRect area = rect().adjusted(8, 0, -4, 0);
  painter->drawText(area.left(), area.top() + metrics.ascent(), declaration_.title);
  painter->setFont(font);
  // Entries flow down, then into further columns.
  const auto count = static_cast<int>(declaration_.curves.size());
  const int fitting = std::max(1, (area.height() - line) / line);
  const int columns = std::clamp((count + fitting - 1) / fitting, 1, kMostColumns);
  const int perColumn = (count + columns - 1) / columns;
  const int width = (area.width() - kColumnGap * (columns - 1)) / columns;
  for (int entry = 0; entry < count; ++entry) {
    const CurveDeclaration& curve = declaration_.curves[static_cast<std::size_t>(entry)];
    const auto index = static_cast<std::size_t>(entry);
    const double value =
        index < values_.size() ? values_[index] : std::numeric_limits<double>::quiet_NaN();
    const QRect box(area.left() + entry / perColumn * (width + kColumnGap),
                    area.top() + (1 + entry % perColumn) * line, width, line);
    const QColor color = curveColor(curve.color, text);
    painter->fillRect(QRect(box.left(), box.center().y() - 1, 10, 3), color);
    painter->setPen(text);
    const QString number = quantityText(declaration_.quantity, value);
    const int room = width - 14 - metrics.horizontalAdvance(number) - 6;
    painter->drawText(box.adjusted(14, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                      metrics.elidedText(curve.name, Qt::ElideRight, room));
    painter->drawText(box, Qt::AlignRight | Qt::AlignVCenter, number);
  }
}

PlotRow::PlotRow(QCustomPlot* plot, const PlotDeclaration& declaration, int layoutRow,
                 QCPMarginGroup* margins)
    : plot_(plot), declaration_(&declaration), rect_(new QCPAxisRect(plot)),
      readout_(new PlotReadout(plot, declaration)) {
  plot->plotLayout()->addElement(layoutRow, 0, rect_);
  plot->plotLayout()->addElement(layoutRow, 1, readout_);
  rect_->setMarginGroup(QCP::msLeft, margins);
  rect_->setMinimumMargins(QMargins(0, kRowGap, 0, kRowGap));
  prepareAxes();
  for (const CurveDeclaration& curve : declaration.curves) {
    auto* graph = plot->addGraph(xAxis(), yAxis());
    graph->setName(curve.name);
    graph->setAdaptiveSampling(false); // done already
    graph->setAntialiased(false);
    graphs_.push_back(graph);
  }
}

void PlotRow::prepareAxes() {
  QCPAxis* y = yAxis();
  y->setNumberFormat(QStringLiteral("gb"));
  y->setNumberPrecision(5);
  y->setSubTicks(false);
  y->setTickLength(0, 3);
  y->setRange(-0.1, 1.1); // numbers of empty plots do not touch those of the next
  if (declaration_->quantity == PlotQuantity::Length) {
    y->setScaleType(QCPAxis::stLogarithmic);
    y->setTicker(QSharedPointer<DecadeTicker>::create());
    y->setRange(1.0, 1000.0);
  } else {
    y->setTicker(QSharedPointer<StepTicker>::create());
    y->ticker()->setTickCount(2);
  }
  QCPAxis* x = xAxis();
  x->setTicker(QSharedPointer<StepTicker>::create());
  x->setNumberFormat(QStringLiteral("gb"));
  x->setNumberPrecision(5);
  x->setSubTicks(false);
  x->setTickLength(0, 3);
  x->ticker()->setTickStepStrategy(QCPAxisTicker::tssReadability);
  for (const auto side : {QCPAxis::atRight, QCPAxis::atTop}) {
    if (rect_->axisCount(side) > 0) {
      rect_->axis(side)->setVisible(false);
    }
  }
}

void PlotRow::fill(const PlotSeries& series, PlotAxis axis) {
  static_cast<StepTicker&>(*xAxis()->ticker()).setWhole(axis != PlotAxis::Time);
  const QCPRange range = xAxis()->range();
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (std::size_t curve = 0; curve < graphs_.size(); ++curve) {
    const std::size_t column = declaration_->curves[curve].column;
    PlotSeries::Line line =
        column < series.columns()
            ? series.line(column, axis, range.lower, range.upper, std::max(50, rect_->width()))
            : PlotSeries::Line{};
    QVector<QCPGraphData> points(static_cast<qsizetype>(line.keys.size()));
    for (qsizetype i = 0; i < points.size(); ++i) {
      const auto at = static_cast<std::size_t>(i);
      const double value = drawnValue(declaration_->quantity, line.values[at]);
      points[i] = {line.keys[at], std::isnan(line.values[at]) ? line.values[at] : value};
      if (std::isfinite(line.values[at])) {
        least = std::min(least, value);
        most = std::max(most, value);
      }
    }
    graphs_[curve]->data()->set(points, true);
  }
  if (least <= most) {
    fit(least, most);
  }
}

void PlotRow::fit(double least, double most) {
  switch (declaration_->quantity) {
  case PlotQuantity::Length:
    // Whole decades, and room for their numbers: the axis stays put while the curve moves.
    yAxis()->setRange(0.6 * std::pow(10.0, std::floor(std::log10(least))),
                      1.5 * std::pow(10.0, std::floor(std::log10(most)) + 1.0));
    break;
  case PlotQuantity::Probability:
    yAxis()->setRange(-0.05, 1.05);
    break;
  case PlotQuantity::Count:
  case PlotQuantity::Pixels:
  case PlotQuantity::Duration:
  case PlotQuantity::Speed: {
    const double top = roundedUp(std::max(most, 1e-9));
    yAxis()->setRange(-0.04 * top, 1.04 * top); // a curve at zero is seen
    break;
  }
  case PlotQuantity::Position:
  case PlotQuantity::LogLikelihood: {
    // Finer than a millimeter, or a difference in probability that says nothing, is not enlarged.
    const double finest = declaration_->quantity == PlotQuantity::Position ? 1e-3 : 1.0;
    const double step = roundedUp(std::max(most - least, finest)) / 5.0;
    yAxis()->setRange((std::floor(least / step) - 0.2) * step,
                      (std::floor(most / step) + 1.0) * step);
    break;
  }
  }
}

void PlotRow::showValues(const PlotSeries& series, std::optional<std::size_t> row) {
  std::vector<double> values;
  for (const CurveDeclaration& curve : declaration_->curves) {
    values.push_back(row && curve.column < series.columns()
                         ? series.value(*row, curve.column)
                         : std::numeric_limits<double>::quiet_NaN());
  }
  readout_->setValues(std::move(values));
}

void PlotRow::applyPalette(const QPalette& palette, const QFont& font) {
  const QColor text = palette.color(QPalette::WindowText);
  const QColor grid = palette.color(QPalette::Mid);
  QFont small = font;
  small.setPointSizeF(font.pointSizeF() * 0.9);
  for (QCPAxis* axis : {xAxis(), yAxis()}) {
    axis->setBasePen(QPen(grid));
    axis->setTickPen(QPen(grid));
    axis->setTickLabelColor(text);
    axis->setLabelColor(text);
    axis->setTickLabelFont(small);
    axis->setLabelFont(small);
    axis->grid()->setPen(QPen(grid, 0.0));
    axis->grid()->setZeroLinePen(Qt::NoPen);
    axis->grid()->setAntialiased(false);
  }
  for (std::size_t curve = 0; curve < graphs_.size(); ++curve) {
    graphs_[curve]->setPen(QPen(curveColor(declaration_->curves[curve].color, text), 0.0));
  }
}

int PlotRow::pointCount() const {
  int count = 0;
  for (const QCPGraph* graph : graphs_) {
    count += graph->dataCount();
  }
  return count;
}

} // namespace dewpoint::ui
