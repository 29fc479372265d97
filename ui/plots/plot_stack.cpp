// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_stack.h"

#include "ui/plots/plot_canvas.h"
#include "ui/plots/plot_cursor.h"
#include "ui/plots/plot_export.h"
#include "ui/plots/plot_pointer.h"
#include "ui/plots/plot_row.h"
#include "ui/plots/plot_scroll.h"
#include "ui/plots/row_heights.h"
#include "ui/text/quantity_text.h"

#include <QEvent>
#include <QLocale>
#include <QToolTip>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace dewpoint::ui {

namespace {

constexpr int kLeastIntervalMs = 120;
constexpr double kEndMargin = 0.005; ///< at either end of the axis, of its length
constexpr int kTopRoom = 4;          ///< above the first plot, pixels
constexpr int kBareMargin = 12;      ///< right of curves that nothing stands beside, pixels
/// Drawing may take this share of the time: with less than 2 ms for each of 30 snapshots a second.
constexpr double kDrawingShare = 0.05;

} // namespace

PlotStack::PlotStack(QWidget* parent)
    : QWidget(parent), plot_(new PlotCanvas(this)), scroll_(new PlotScroll(plot_, this)),
      navigation_(new PlotNavigation(this)), pointer_(new PlotPointer(*navigation_, plot_, [this] {
        return rows_.empty() ? nullptr : rows_.front()->xAxis();
      })) {
  plot_->setFocusPolicy(Qt::StrongFocus);
  plot_->setMouseTracking(true);
  plot_->setNoAntialiasingOnDrag(true);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll_);
  setFocusProxy(plot_);
  plot_->plotLayout()->clear();
  plot_->addLayer(QStringLiteral("cursor"), plot_->layer(QStringLiteral("overlay")));
  plot_->layer(QStringLiteral("cursor"))->setMode(QCPLayer::lmBuffered);
  cursor_ = new PlotCursor(plot_, QStringLiteral("cursor"));
  connect(navigation_, &PlotNavigation::shownRangeChanged, this, &PlotStack::draw);
  connect(navigation_, &PlotNavigation::cursorChanged, this, &PlotStack::drawCursor);
  connect(pointer_, &PlotPointer::frameHovered, this, &PlotStack::frameHovered);
  connect(pointer_, &PlotPointer::cursorMoved, this, &PlotStack::showLabel);
  connect(pointer_, &PlotPointer::contextMenuRequested, this, &PlotStack::contextMenuRequested);
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &PlotStack::draw);
  sinceDrawing_.start();
  applyPalette();
}

PlotStack::~PlotStack() = default;

void PlotStack::setEmptyText(const QString& sentence) {
  scroll_->setEmptyText(sentence);
}

void PlotStack::setCurvesOnly(bool bare) {
  curvesOnly_ = bare;
  scroll_->setNameShown(!bare);
  rebuild();
}

void PlotStack::setPlots(std::vector<PlotDeclaration> plots) {
  scroll_->setAxis(nullptr, axis());
  rows_.clear(); // they point into the old ones
  plot_->clearGraphs();
  plot_->plotLayout()->clear();
  plots_ = std::move(plots);
  rebuild();
}

void PlotStack::setShownPlots(const QStringList& ids) {
  shown_ = ids;
  rebuild();
}

void PlotStack::setSeries(const PlotSeries* series) {
  navigation_->setSeries(series);
  refresh();
}

std::vector<const PlotDeclaration*> PlotStack::plotsToShow() const {
  std::vector<const PlotDeclaration*> chosen;
  std::vector<const PlotDeclaration*> known;
  for (const PlotDeclaration& plot : plots_) {
    if (shown_.contains(plot.id)) {
      chosen.push_back(&plot);
      if (series() != nullptr && std::ranges::any_of(plot.curves, [this](const auto& curve) {
            return curve.column < series()->columnCount() &&
                   series()->hasValuesInColumn(curve.column);
          })) {
        known.push_back(&plot);
      }
    }
  }
  return known.empty() ? chosen : known;
}

void PlotStack::rebuild() {
  scroll_->setAxis(nullptr, axis());
  rows_.clear();
  cursor_->axisRects.clear();
  plot_->clearGraphs();
  plot_->plotLayout()->clear();
  delete plot_->findChild<QCPMarginGroup*>();
  auto* margins = new QCPMarginGroup(plot_);
  plot_->plotLayout()->setRowSpacing(0);
  plot_->plotLayout()->setColumnSpacing(0);
  const auto wanted = plotsToShow();
  for (const PlotDeclaration* plot : wanted) {
    rows_.push_back(
        std::make_unique<PlotRow>(plot_, *plot, static_cast<int>(rows_.size()), margins));
    cursor_->axisRects.push_back(rows_.back()->rect());
  }
  arrangeRows(wanted);
  scroll_->setAxis(rows_.empty() ? nullptr : rows_.front()->xAxis(), axis());
  applyPalette();
  draw();
}

void PlotStack::arrangeRows(const std::vector<const PlotDeclaration*>& wanted) {
  const int captionWidth = curvesOnly_ ? 0 : PlotCaption::widthFor(wanted, font());
  const int readoutWidth = curvesOnly_ ? kBareMargin : PlotReadout::widthFor(wanted, font());
  for (const auto& row : rows_) {
    row->caption()->setWidth(captionWidth);
    row->readout()->setWidth(readoutWidth);
  }
  if (!rows_.empty()) { // a number at the upper end of an axis is not cut off
    QMargins margins = rows_.front()->rect()->margins();
    margins.setTop(margins.top() + kTopRoom);
    rows_.front()->rect()->setMargins(margins);
  }
  fittedHeight_ = -1;
  fitRows();
}

void PlotStack::fitRows() {
  const int visible = scroll_->visibleArea().height();
  if (visible == fittedHeight_) {
    return;
  }
  fittedHeight_ = visible;
  std::vector<int> least;
  for (const auto& row : rows_) {
    least.push_back(row->minimumHeightFor(font()) + (least.empty() ? kTopRoom : 0));
  }
  // The gap below the last visible plot need not be visible.
  const std::vector<int> heights = heightsForWholeRows(least, visible + PlotRow::kGapPx);
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const double share = heights.empty() ? rows_[k]->heightWeight() : heights[k];
    plot_->plotLayout()->setRowStretchFactor(static_cast<int>(k), share);
  }
  plot_->setMinimumHeight(heights.empty()
                              ? std::min(visible, std::accumulate(least.begin(), least.end(), 0))
                              : std::accumulate(heights.begin(), heights.end(), 0));
}

void PlotStack::refresh() {
  if (timer_.isActive() || !isVisible()) {
    return;
  }
  const double pause = std::max<double>(kLeastIntervalMs, lastDrawingMs_ / kDrawingShare);
  timer_.start(
      static_cast<int>(std::max(0.0, pause - static_cast<double>(sinceDrawing_.elapsed()))));
}

void PlotStack::draw() {
  scroll_->setEmptyTextShown(series() == nullptr || series()->size() == 0);
  if (!isVisible() || series() == nullptr) {
    return;
  }
  const auto wanted = plotsToShow();
  const bool same = std::ranges::equal(
      wanted, rows_, [](const auto* plot, const auto& row) { return plot == &row->declaration(); });
  if (!same) {
    rebuild(); // a plot has got its first numbers
    return;
  }
  QElapsedTimer took;
  took.start();
  fitRows();
  const auto [lower, upper] = navigation_->followNewestData();
  const double margin = kEndMargin * (upper - lower); // the first dot is seen in full
  for (const auto& row : rows_) {
    row->xAxis()->setRange(lower - margin, upper + margin);
    row->fill(*series(), axis());
  }
  placeCursor();
  plot_->replot();
  lastDrawingMs_ = static_cast<double>(took.nsecsElapsed()) * 1e-6;
  sinceDrawing_.restart();
}

void PlotStack::drawCursor() {
  placeCursor();
  if (isVisible()) {
    plot_->layer(QStringLiteral("cursor"))->replot();
  }
}

void PlotStack::placeCursor() {
  cursor_->currentPosition = navigation_->positionOf(navigation_->currentFrame());
  cursor_->hoveredPosition = navigation_->positionOf(navigation_->hoveredFrame());
  cursor_->draggedRange = navigation_->draggedRange();
  cursor_->selectedRange.reset();
  if (const auto range = navigation_->selectedRange()) {
    const auto first = navigation_->positionOf(range->first);
    const auto last = navigation_->positionOf(range->last);
    if (last) {
      cursor_->selectedRange = std::pair(first.value_or(series()->axisPosition(0, axis())), *last);
    }
  }
  // The numbers beside the plots belong to the frame in all views; the label shows the cursor's.
  const auto row = navigation_->shownRow();
  for (const auto& plot : rows_) {
    plot->showValues(series() != nullptr ? *series() : PlotSeries(), row);
  }
  Q_EMIT cursorMoved();
}

void PlotStack::setAxis(PlotAxis axis) {
  if (navigation_->setAxis(axis)) {
    scroll_->setAxis(rows_.empty() ? nullptr : rows_.front()->xAxis(), axis);
    draw();
  }
}

void PlotStack::connectSelection(Selection& selection) {
  connect(pointer_, &PlotPointer::frameChosen, &selection, &Selection::requestFrame);
  connect(pointer_, &PlotPointer::rangeChosen, &selection, [&selection](qint64 first, qint64 last) {
    selection.selectRange(SelectedRange{first, last});
  });
  connect(pointer_, &PlotPointer::rangeCleared, &selection,
          [&selection] { selection.selectRange(std::nullopt); });
  connect(&selection, &Selection::selectedRangeChanged, this,
          [this, &selection] { navigation_->setSelectedRange(selection.selectedRange()); });
}

void PlotStack::shareCursor(PlotStack& other) {
  const auto tell = [](PlotStack& from, PlotStack& to) {
    connect(&from, &PlotStack::frameHovered, &to, [&to](qint64 frame) {
      to.setHoveredFrame(frame < 0 ? std::nullopt : std::optional<std::int64_t>(frame));
    });
  };
  tell(*this, other);
  tell(other, *this);
}

int PlotStack::drawnPointCount() const {
  int count = 0;
  for (const auto& row : rows_) {
    count += row->pointCount();
  }
  return count;
}

QStringList PlotStack::visiblePlots() const {
  QStringList ids;
  for (const auto& row : rows_) {
    ids << row->declaration().id;
  }
  return ids;
}

QStringList PlotStack::fullyVisiblePlots() const {
  const QRect sight = scroll_->visibleArea();
  QStringList ids;
  for (const auto& row : rows_) {
    const QRect its = row->rect()->rect();
    if (its.top() >= sight.top() && its.bottom() <= sight.bottom()) {
      ids << row->declaration().id;
    }
  }
  return ids;
}

QStringList PlotStack::partlyVisiblePlots() const {
  const QRect sight = scroll_->visibleArea();
  QStringList ids;
  for (const auto& row : rows_) {
    const QRect its = row->rect()->rect();
    const bool visible = its.bottom() >= sight.top() && its.top() <= sight.bottom();
    if (visible && (its.top() < sight.top() || its.bottom() > sight.bottom())) {
      ids << row->declaration().id;
    }
  }
  return ids;
}

bool PlotStack::hasDots() const {
  return std::ranges::any_of(rows_, [](const auto& row) { return row->hasDots(); });
}

void PlotStack::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LocaleChange) { // the plot has one of its own
    QLocale numbers = locale();
    numbers.setNumberOptions(plot_->locale().numberOptions());
    plot_->setLocale(numbers);
  }
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange ||
      event->type() == QEvent::LocaleChange) {
    applyPalette();
    // The plot gets its palette after this widget.
    QMetaObject::invokeMethod(this, &PlotStack::draw, Qt::QueuedConnection);
  }
}

void PlotStack::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitRows();
  refresh();
}

void PlotStack::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  refresh();
}

void PlotStack::applyPalette() {
  plot_->setBackground(palette().color(QPalette::Base));
  for (const auto& row : rows_) {
    row->applyPalette(palette(), font());
  }
}

void PlotStack::showLabel(const std::optional<QPoint>& pointer) {
  const auto row = navigation_->hoveredFrame() ? navigation_->cursorRow() : std::nullopt;
  if (!row || rows_.empty()) {
    QToolTip::hideText();
    return;
  }
  QStringList lines{cursorText()};
  for (const auto& plot : rows_) {
    const QRect area = plot->rect()->outerRect();
    if (!pointer || (area.top() <= pointer->y() && pointer->y() <= area.bottom())) {
      lines << plot->valuesText(*series(), row);
    }
  }
  if (!curvesOnly_) {
    lines << tr("Click: go to this frame · Ctrl+wheel: zoom");
  }
  const QPoint place = pointer.value_or(
      QPoint(qRound(rows_.front()->xAxis()->coordToPixel(series()->axisPosition(*row, axis()))),
             scroll_->visibleArea().top()));
  // With an area of one pixel, the label moves along with the pointer.
  QToolTip::showText(plot_->mapToGlobal(place), lines.join(QLatin1Char('\n')), plot_,
                     QRect(place, QSize(1, 1)));
}

QString PlotStack::placeText(const std::optional<std::size_t>& row) const {
  if (!row) {
    return {};
  }
  const PlotSeries::Row& at = series()->row(*row);
  const QString frame = frameNumberText(at.frame);
  const QString time = secondsText(at.seconds, 2);
  return axis() == PlotAxis::Time
             ? tr("frame %1, %2").arg(frame, time)
             : tr("frame %1, iteration %2, %3").arg(frame, QString::number(at.iteration), time);
}

QString PlotStack::valuesText() const {
  QStringList parts;
  if (const QString place = cursorText(); !place.isEmpty()) {
    parts << place;
  }
  for (const auto& row : rows_) {
    parts << row->valuesText(series() != nullptr ? *series() : PlotSeries(),
                             navigation_->cursorRow());
  }
  return parts.join(QStringLiteral("; "));
}

PlotExport PlotStack::plotExport() {
  return {*plot_, rows_, *navigation_, *cursor_, [this] { draw(); }};
}

} // namespace dewpoint::ui
