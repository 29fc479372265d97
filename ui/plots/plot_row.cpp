// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_row.h"

#include "ui/plots/plot_tickers.h"
#include "ui/style/tabular_font.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dewpoint::ui {

namespace {

constexpr int kLeastRect = 20;      ///< height of the axes
constexpr int kTickRoom = 22;       ///< pixels of the y axis for each number on it
constexpr int kCaptionLines = 2;    ///< of a title
constexpr double kDeviations = 2.0; ///< of a band, to either side
constexpr int kBandAlpha = 52;
constexpr double kCurveWidth = 1.2;
constexpr double kFigureWidth = 1.4;
constexpr double kTruthWidth = 1.0;
constexpr int kTruthAlpha = 150;
constexpr double kDotSize = 4.5;
/// Smooth lines of more points would take too long while a run goes on.
constexpr qsizetype kMostSmoothPoints = 400;
constexpr double kPositionShare = 1.4; ///< of the height: it has most curves, and is looked at most

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

/// Finer than that nothing is enlarged: what differs by less says nothing.
double finestRange(PlotQuantity quantity) {
  switch (quantity) {
  case PlotQuantity::Position:
    return 1e-3;
  case PlotQuantity::PixelPosition:
    return 10.0;
  default:
    return 1.0;
  }
}

bool isPosition(PlotQuantity quantity) {
  return quantity == PlotQuantity::Position || quantity == PlotQuantity::PixelPosition;
}

} // namespace

PlotRow::Extremes::Extremes()
    : minimum(std::numeric_limits<double>::infinity()),
      maximum(-std::numeric_limits<double>::infinity()) {}

void PlotRow::Extremes::extendBy(const Extremes& other) {
  minimum = std::min(minimum, other.minimum);
  maximum = std::max(maximum, other.maximum);
  pointCount += other.pointCount;
}

PlotRow::PlotRow(QCustomPlot* plot, const PlotDeclaration& declaration, int layoutRow,
                 QCPMarginGroup* margins)
    : plot_(plot), declaration_(&declaration), caption_(new PlotCaption(plot, declaration)),
      rect_(new QCPAxisRect(plot)), readout_(new PlotReadout(plot, declaration)) {
  plot->plotLayout()->addElement(layoutRow, 0, caption_);
  plot->plotLayout()->addElement(layoutRow, 1, rect_);
  plot->plotLayout()->addElement(layoutRow, 2, readout_);
  plot->plotLayout()->setRowStretchFactor(layoutRow, heightWeight());
  rect_->setMarginGroup(QCP::msLeft, margins);
  rect_->setAutoMargins(QCP::msLeft); // no row needs room for the numbers of the shared axis
  rect_->setMargins(QMargins(0, kGapPx, kGapPx, kGapPx));
  rect_->setMinimumSize(kLeastRect, kLeastRect);
  for (QCPLayoutElement* beside :
       {static_cast<QCPLayoutElement*>(caption_), static_cast<QCPLayoutElement*>(readout_)}) {
    beside->setMargins(QMargins(0, kGapPx / 2, 0, 0));
  }
  prepareAxes();
  addGraphs();
}

QCPGraph* PlotRow::addGraph(const QString& name) {
  auto* graph = plot_->addGraph(xAxis(), yAxis());
  graph->setName(name);
  graph->setAdaptiveSampling(false); // done already
  graph->setAntialiased(false);
  return graph;
}

void PlotRow::addGraphs() {
  graphs_.resize(declaration_->curves.size());
  // Bands lie below all lines, and the truth below the curves.
  for (std::size_t k = 0; k < graphs_.size(); ++k) {
    const CurveDeclaration& curve = declaration_->curves[k];
    if (curve.deviation) {
      graphs_[k].lowerBandEdge = addGraph(curve.name);
      graphs_[k].upperBandEdge = addGraph(curve.name);
      graphs_[k].lowerBandEdge->setPen(Qt::NoPen);
      graphs_[k].upperBandEdge->setPen(Qt::NoPen);
      graphs_[k].upperBandEdge->setChannelFillGraph(graphs_[k].lowerBandEdge);
    }
  }
  for (std::size_t k = 0; k < graphs_.size(); ++k) {
    if (declaration_->curves[k].truth) {
      graphs_[k].truthCurve = addGraph(declaration_->curves[k].name);
    }
  }
  for (std::size_t k = 0; k < graphs_.size(); ++k) {
    graphs_[k].curve = addGraph(declaration_->curves[k].name);
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
    y->setTicker(QSharedPointer<ValueTicker>::create());
  }
  QCPAxis* x = xAxis();
  x->setTicker(QSharedPointer<StepTicker>::create());
  x->setNumberFormat(QStringLiteral("gb"));
  x->setNumberPrecision(5);
  x->setSubTicks(false);
  x->setTickLength(0, 3);
  x->setTickLabels(false); // below all plots, but for a figure
  x->ticker()->setTickStepStrategy(QCPAxisTicker::tssReadability);
  for (const auto side : {QCPAxis::atRight, QCPAxis::atTop}) {
    if (rect_->axisCount(side) > 0) {
      rect_->axis(side)->setVisible(false);
    }
  }
}

int PlotRow::minimumHeightFor(const QFont& font) const {
  const int line = PlotReadout::lineHeight(font);
  const int lines = std::max(kCaptionLines, PlotReadout::lineCount(*declaration_));
  return static_cast<int>(std::lround(heightWeight() * (kCaptionLines * line + 2 * kGapPx))) +
         std::max(0, lines - kCaptionLines) * line;
}

double PlotRow::heightWeight() const {
  return isPosition(declaration_->quantity) && declaration_->curves.size() > 1 ? kPositionShare
                                                                               : 1.0;
}

void PlotRow::updateMaxTicks() {
  const int most = std::max(2, rect_->height() / kTickRoom);
  if (declaration_->quantity == PlotQuantity::Length) {
    static_cast<DecadeTicker&>(*yAxis()->ticker()).setMaxTicks(most);
  } else {
    static_cast<ValueTicker&>(*yAxis()->ticker()).setMaxTicks(most);
  }
}

PlotRow::Extremes PlotRow::draw(QCPGraph* graph, const PlotSeries& series, PlotAxis axis,
                                std::size_t column,
                                const std::optional<PlotSeries::ColumnOffset>& offset) const {
  Extremes extremes;
  const QCPRange range = xAxis()->range();
  const bool known =
      column < series.columnCount() && (!offset || offset->column < series.columnCount());
  const PlotSeries::CurvePoints line =
      known ? series.curvePoints(column, axis, range.lower, range.upper,
                                 std::max(50, rect_->width()), offset)
            : PlotSeries::CurvePoints{};
  QVector<QCPGraphData> points(static_cast<qsizetype>(line.axisPositions.size()));
  for (qsizetype i = 0; i < points.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double value = valueInAxisUnit(declaration_->quantity, line.values[at]);
    points[i] = {line.axisPositions[at], std::isnan(line.values[at]) ? line.values[at] : value};
    if (std::isfinite(line.values[at])) {
      extremes.minimum = std::min(extremes.minimum, value);
      extremes.maximum = std::max(extremes.maximum, value);
      ++extremes.pointCount;
    }
  }
  const bool smooth = points.size() <= kMostSmoothPoints;
  graph->setAntialiased(smooth);
  graph->setAntialiasedFill(smooth);
  if (QPen pen = graph->pen(); pen.style() == Qt::SolidLine) {
    pen.setWidthF(smooth ? kCurveWidth : 0.0);
    graph->setPen(pen);
  }
  graph->data()->set(points, true);
  return extremes;
}

void PlotRow::fill(const PlotSeries& series, PlotAxis axis) {
  static_cast<StepTicker&>(*xAxis()->ticker()).setWholeNumbers(axis != PlotAxis::Time);
  Extremes values;
  Extremes bands;
  bool truthKnown = false;
  for (std::size_t k = 0; k < graphs_.size(); ++k) {
    const CurveDeclaration& curve = declaration_->curves[k];
    const CurveGraphs& drawn = graphs_[k];
    const Extremes its = draw(drawn.curve, series, axis, curve.column);
    const bool few = its.pointCount > 0 && its.pointCount <= kMaxDots;
    const QColor color = drawn.curve->pen().color();
    drawn.curve->setScatterStyle(
        few ? QCPScatterStyle(QCPScatterStyle::ssDisc, color, color, kDotSize) : QCPScatterStyle());
    values.extendBy(its);
    if (curve.deviation) {
      bands.extendBy(draw(drawn.lowerBandEdge, series, axis, curve.column,
                          PlotSeries::ColumnOffset{*curve.deviation, -kDeviations}));
      bands.extendBy(draw(drawn.upperBandEdge, series, axis, curve.column,
                          PlotSeries::ColumnOffset{*curve.deviation, kDeviations}));
    }
    if (curve.truth) {
      values.extendBy(draw(drawn.truthCurve, series, axis, *curve.truth));
      truthKnown = truthKnown ||
                   (*curve.truth < series.columnCount() && series.hasValuesInColumn(*curve.truth));
    }
  }
  readout_->setHasGroundTruth(truthKnown);
  updateMaxTicks();
  if (values.hasValues()) {
    fit(values, bands);
  }
}

void PlotRow::fit(const Extremes& values, const Extremes& bands) {
  const PlotQuantity quantity = declaration_->quantity;
  double least = values.minimum;
  double most = values.maximum;
  switch (quantity) {
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
  case PlotQuantity::PixelPosition:
  case PlotQuantity::LogLikelihood: {
    const double size = std::max(most - least, finestRange(quantity));
    if (bands.hasValues()) { // a wide band must not flatten the curves
      least = std::min(least, std::max(bands.minimum, least - 0.5 * size));
      most = std::max(most, std::min(bands.maximum, most + 0.5 * size));
    }
    const double step = roundedUp(std::max(most - least, finestRange(quantity))) / 5.0;
    yAxis()->setRange((std::floor(least / step) - 0.2) * step,
                      (std::floor(most / step) + 1.2) * step);
    break;
  }
  }
}

std::vector<double> PlotRow::valuesOf(const PlotSeries& series,
                                      std::optional<std::size_t> row) const {
  std::vector<double> values;
  for (const CurveDeclaration& curve : declaration_->curves) {
    values.push_back(row && curve.column < series.columnCount()
                         ? series.value(*row, curve.column)
                         : std::numeric_limits<double>::quiet_NaN());
  }
  return values;
}

void PlotRow::showValues(const PlotSeries& series, std::optional<std::size_t> row) {
  readout_->setValues(valuesOf(series, row));
}

QString PlotRow::valuesText(const PlotSeries& series, std::optional<std::size_t> row) const {
  return QStringLiteral("%1: %2").arg(declaration_->title,
                                      PlotReadout::textOf(*declaration_, valuesOf(series, row)));
}

void PlotRow::applyPalette(const QPalette& palette, const QFont& font) {
  const QColor text = palette.color(QPalette::WindowText);
  const QColor grid = palette.color(QPalette::Mid);
  QFont small = font;
  small.setPointSizeF(font.pointSizeF() * 0.9);
  small = tabularFont(small);
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
  for (std::size_t k = 0; k < graphs_.size(); ++k) {
    const QColor color = curveColor(declaration_->curves[k].colorIndex, text);
    graphs_[k].curve->setPen(QPen(color, kCurveWidth));
    if (graphs_[k].upperBandEdge != nullptr) {
      QColor faint = color;
      faint.setAlpha(kBandAlpha);
      graphs_[k].upperBandEdge->setBrush(faint);
    }
    if (graphs_[k].truthCurve != nullptr) {
      QColor quiet = text;
      quiet.setAlpha(kTruthAlpha);
      graphs_[k].truthCurve->setPen(QPen(quiet, kTruthWidth, Qt::DashLine));
    }
  }
}

void PlotRow::setDrawnForFigure(bool figure) {
  for (const CurveGraphs& drawn : graphs_) {
    QPen pen = drawn.curve->pen();
    pen.setWidthF(figure ? kFigureWidth : kCurveWidth);
    drawn.curve->setPen(pen);
    for (QCPGraph* graph :
         {drawn.curve, drawn.lowerBandEdge, drawn.upperBandEdge, drawn.truthCurve}) {
      if (graph != nullptr) {
        graph->setAntialiased(true);
      }
    }
  }
}

int PlotRow::pointCount() const {
  int count = 0;
  for (const QCPGraph* graph : rect_->graphs()) {
    count += graph->dataCount();
  }
  return count;
}

bool PlotRow::hasDots() const {
  return std::ranges::any_of(
      graphs_, [](const CurveGraphs& drawn) { return !drawn.curve->scatterStyle().isNone(); });
}

} // namespace dewpoint::ui
