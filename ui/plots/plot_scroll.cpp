// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plot_scroll.h"

#include "ui/plots/plot_axis_strip.h"

#include <QEvent>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <qcustomplot.h>

namespace dewpoint::ui {

namespace {
constexpr int kLeastPlotHeight = 40; ///< of what is scrolled, pixels
} // namespace

PlotScroll::PlotScroll(QCustomPlot* plot, QWidget* parent)
    : QWidget(parent), plot_(plot), scroll_(new QScrollArea(this)),
      strip_(new PlotAxisStrip(*plot, this)), empty_(new QLabel(this)) {
  scroll_->setObjectName(QStringLiteral("plotScroll"));
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setMinimumHeight(kLeastPlotHeight);
  scroll_->setWidget(plot);
  empty_->setObjectName(QStringLiteral("plotsEmpty"));
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  empty_->setAutoFillBackground(true);
  empty_->setAttribute(Qt::WA_TransparentForMouseEvents);
  empty_->hide();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(scroll_, 1);
  layout->addWidget(strip_);
  applyPalette();
}

void PlotScroll::setAxis(QCPAxis* axis, PlotAxis kind) {
  strip_->setAxis(axis, kind);
}

void PlotScroll::setNameShown(bool named) {
  strip_->setNameShown(named);
}

void PlotScroll::setEmptyText(const QString& sentence) {
  empty_->setText(sentence);
}

void PlotScroll::setEmptyTextShown(bool isEmpty) {
  const bool wanted = isEmpty && !empty_->text().isEmpty();
  if (wanted != !empty_->isHidden()) {
    empty_->setVisible(wanted);
    empty_->raise();
  }
}

QRect PlotScroll::visibleArea() const {
  return {-plot_->pos(), scroll_->viewport()->size()};
}

void PlotScroll::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    applyPalette();
  }
}

void PlotScroll::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  empty_->setGeometry(rect());
}

void PlotScroll::applyPalette() {
  QPalette quiet = palette();
  quiet.setColor(QPalette::Window, palette().color(QPalette::Base));
  quiet.setColor(QPalette::WindowText, palette().color(QPalette::PlaceholderText));
  empty_->setPalette(quiet);
}

} // namespace dewpoint::ui
