// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/range_bar.h"

#include <QFocusEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

namespace {

constexpr double kRangeMargin = 9.0;
constexpr double kStrip = 10.0; ///< height of the colored strip
constexpr double kLeast = 0.01; ///< of a range: an empty one matches nothing
constexpr double kRangeHandle = 7.0;

} // namespace

RangeBar::RangeBar(QWidget* parent) : QWidget(parent), low_(Qt::black), high_(Qt::white) {
  setFocusPolicy(Qt::StrongFocus);
}

void RangeBar::setRange(double from, double to) {
  from_ = from;
  to_ = to;
  update();
}

void RangeBar::setHistogram(std::vector<double> counts) {
  histogram_ = std::move(counts);
  update();
}

void RangeBar::setColors(const QColor& low, const QColor& high) {
  low_ = low;
  high_ = high;
  update();
}

QRectF RangeBar::bar() const {
  return {kRangeMargin, 2.0, width() - 2.0 * kRangeMargin, height() - kStrip / 2.0 - 6.0};
}

double RangeBar::xOf(double value) const {
  return bar().left() + value * bar().width();
}

double RangeBar::valueAt(double x) const {
  return (x - bar().left()) / std::max(1.0, bar().width());
}

RangeBar::Part RangeBar::partAt(QPointF position) const {
  const double toFrom = std::abs(position.x() - xOf(from_));
  const double toTo = std::abs(position.x() - xOf(to_));
  if (std::min(toFrom, toTo) <= 1.5 * kRangeHandle) {
    // Two handles on one spot: the side of the press decides.
    return toFrom < toTo || (toFrom == toTo && position.x() < xOf(from_)) ? Part::From : Part::To;
  }
  return position.x() > xOf(from_) && position.x() < xOf(to_) ? Part::Both : Part::None;
}

void RangeBar::move(Part part, double change) {
  double from = from_;
  double to = to_;
  switch (part) {
  case Part::From:
    from = std::clamp(from_ + change, 0.0, to_ - kLeast);
    break;
  case Part::To:
    to = std::clamp(to_ + change, from_ + kLeast, 1.0);
    break;
  default:
    change = std::clamp(change, -from_, 1.0 - to_);
    from = from_ + change;
    to = to_ + change;
  }
  if (from != from_ || to != to_) {
    setRange(from, to);
    Q_EMIT rangeEdited(from, to);
  }
}

void RangeBar::mousePressEvent(QMouseEvent* event) {
  dragged_ = event->button() == Qt::LeftButton ? partAt(event->position()) : Part::None;
  lastValue_ = valueAt(event->position().x());
  if (dragged_ != Part::None) {
    chosen_ = dragged_;
    update();
  }
}

void RangeBar::mouseMoveEvent(QMouseEvent* event) {
  if (dragged_ == Part::None) {
    return;
  }
  const double value = valueAt(event->position().x());
  const double reference = dragged_ == Part::From ? from_ : dragged_ == Part::To ? to_ : lastValue_;
  move(dragged_, value - reference);
  lastValue_ = value;
}

void RangeBar::mouseReleaseEvent(QMouseEvent*) {
  if (dragged_ != Part::None) {
    dragged_ = Part::None;
    Q_EMIT editingFinished();
  }
}

void RangeBar::keyPressEvent(QKeyEvent* event) {
  const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? 0.1 : 0.01;
  switch (event->key()) {
  case Qt::Key_Left:
  case Qt::Key_Down:
    move(chosen_, -step);
    return;
  case Qt::Key_Right:
  case Qt::Key_Up:
    move(chosen_, step);
    return;
  default:
    QWidget::keyPressEvent(event);
  }
}

void RangeBar::focusInEvent(QFocusEvent* event) {
  if (event->reason() == Qt::TabFocusReason) {
    chosen_ = Part::From;
  } else if (event->reason() == Qt::BacktabFocusReason) {
    chosen_ = Part::Both;
  }
  QWidget::focusInEvent(event);
}

bool RangeBar::focusNextPrevChild(bool next) {
  constexpr Part kOrder[] = {Part::From, Part::To, Part::Both};
  const auto* at = std::ranges::find(kOrder, chosen_);
  if (hasFocus() && (next ? at + 1 != std::end(kOrder) : at != std::begin(kOrder))) {
    chosen_ = next ? *(at + 1) : *(at - 1);
    Q_EMIT editingFinished();
    update();
    return true;
  }
  return QWidget::focusNextPrevChild(next);
}

void RangeBar::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setOpacity(isEnabled() ? 1.0 : 0.4);
  const QRectF area = bar();
  const double base = area.bottom() - kStrip;
  if (!histogram_.empty()) {
    const double most = *std::ranges::max_element(histogram_);
    QPolygonF shape{QPointF(area.left(), base)};
    for (std::size_t i = 0; most > 0.0 && i < histogram_.size(); ++i) {
      const double value = (static_cast<double>(i) + 0.5) / static_cast<double>(histogram_.size());
      shape << QPointF(xOf(value), base - (base - area.top()) * std::sqrt(histogram_[i] / most));
    }
    shape << QPointF(area.right(), base);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Mid));
    painter.drawPolygon(shape);
  }
  constexpr int kSteps = 64; // in steps, not as a gradient: what is drawn are colors
  for (int i = 0; i < kSteps; ++i) {
    const auto share = static_cast<float>(i) / (kSteps - 1);
    const auto blend = [&](float a, float b) { return a + (b - a) * share; };
    const QColor color =
        QColor::fromRgbF(blend(low_.redF(), high_.redF()), blend(low_.greenF(), high_.greenF()),
                         blend(low_.blueF(), high_.blueF()));
    painter.fillRect(
        QRectF(xOf(static_cast<double>(i) / kSteps), base, area.width() / kSteps + 0.5, kStrip),
        color);
  }
  QColor veil = palette().color(QPalette::Window);
  veil.setAlphaF(0.72F);
  painter.fillRect(QRectF(area.left(), base, xOf(from_) - area.left(), kStrip), veil);
  painter.fillRect(QRectF(xOf(to_), base, area.right() - xOf(to_), kStrip), veil);
  const QColor accent = palette().color(QPalette::Highlight);
  const QColor text = palette().color(QPalette::Text);
  painter.setPen(QPen(hasFocus() && chosen_ == Part::Both ? accent : text, 2.0));
  painter.drawLine(QPointF(xOf(from_), base - 2.0), QPointF(xOf(to_), base - 2.0));
  for (const auto& [value, part] : {std::pair(from_, Part::From), std::pair(to_, Part::To)}) {
    painter.setPen(QPen(hasFocus() && chosen_ == part ? accent : text, 2.0));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawEllipse(QPointF(xOf(value), base + kStrip / 2.0), kRangeHandle, kRangeHandle);
  }
}

} // namespace dewpoint::ui
