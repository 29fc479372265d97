// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/hue_ring.h"

#include <QFocusEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dewpoint::ui {

namespace {

constexpr double kThickness = 18.0;
constexpr double kRingHandle = 7.0;
constexpr double kRingMargin = 10.0;
constexpr double kFull = 360.0;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

double wrapped(double degrees) {
  const double rest = std::fmod(degrees, kFull);
  return rest < 0.0 ? rest + kFull : rest;
}

/// How far the arc reaches from its beginning, 0 to 360.
double width(double from, double to) {
  return from == to ? 0.0 : (to - from >= kFull ? kFull : wrapped(to - from));
}

/// The shortest way from one hue to another, -180 to 180.
double difference(double a, double b) {
  const double d = wrapped(b - a);
  return d > kFull / 2.0 ? d - kFull : d;
}

} // namespace

HueRing::HueRing(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
}

void HueRing::setRange(double from, double to) {
  from_ = from;
  to_ = to;
  update();
}

void HueRing::setHistogram(std::vector<double> counts) {
  histogram_ = std::move(counts);
  update();
}

double HueRing::radius() const {
  return std::min(width(), height()) / 2.0 - kRingMargin;
}

QPointF HueRing::pointAt(double hue, double distance) const {
  // Red at the right, counterclockwise as in the book.
  return QPointF(width() / 2.0, height() / 2.0) +
         distance * QPointF(std::cos(radians(hue)), -std::sin(radians(hue)));
}

double HueRing::hueAt(QPointF position) const {
  const QPointF d = position - QPointF(width() / 2.0, height() / 2.0);
  return wrapped(std::atan2(-d.y(), d.x()) * 180.0 / std::numbers::pi);
}

HueRing::Part HueRing::partAt(QPointF position) const {
  const double middle = radius() - kThickness / 2.0;
  const auto distance = [&](double hue) {
    const QPointF d = position - pointAt(hue, middle);
    return std::hypot(d.x(), d.y());
  };
  const double reach = kThickness;
  if (std::min(distance(from_), distance(to_)) <= reach) {
    return distance(from_) <= distance(to_) ? Part::From : Part::To;
  }
  const QPointF d = position - QPointF(width() / 2.0, height() / 2.0);
  const double r = std::hypot(d.x(), d.y());
  const bool onRing = r > radius() - 1.6 * kThickness && r < radius() + kRingMargin;
  const bool inRange = wrapped(hueAt(position) - from_) <= dewpoint::ui::width(from_, to_);
  return onRing && inRange ? Part::Arc : Part::None;
}

void HueRing::move(Part part, double degrees) {
  double from = from_;
  double to = to_;
  const double wide = dewpoint::ui::width(from_, to_);
  if (part == Part::Arc) {
    from = wrapped(from_ + degrees);
    to = wrapped(to_ + degrees);
  } else {
    // An end stops before the other one: an empty range matches nothing.
    const double change =
        std::clamp(part == Part::From ? -degrees : degrees, 1.0 - wide, kFull - 1.0 - wide);
    (part == Part::From ? from : to) = wrapped(part == Part::From ? from_ - change : to_ + change);
  }
  if (from != from_ || to != to_) {
    setRange(from, to);
    Q_EMIT rangeEdited(from, to);
  }
}

void HueRing::mousePressEvent(QMouseEvent* event) {
  dragged_ = event->button() == Qt::LeftButton ? partAt(event->position()) : Part::None;
  lastHue_ = hueAt(event->position());
  if (dragged_ != Part::None) {
    chosen_ = dragged_;
    update();
  }
}

void HueRing::mouseMoveEvent(QMouseEvent* event) {
  if (dragged_ == Part::None) {
    setCursor(partAt(event->position()) == Part::None ? Qt::ArrowCursor : Qt::OpenHandCursor);
    return;
  }
  const double hue = hueAt(event->position());
  // An end goes to the hand, the arc goes along with it.
  const double reference = dragged_ == Part::From ? from_ : dragged_ == Part::To ? to_ : lastHue_;
  move(dragged_, difference(reference, hue));
  lastHue_ = hue;
}

void HueRing::mouseReleaseEvent(QMouseEvent*) {
  if (dragged_ != Part::None) {
    dragged_ = Part::None;
    Q_EMIT editingFinished();
  }
}

void HueRing::keyPressEvent(QKeyEvent* event) {
  const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? 10.0 : 1.0;
  switch (event->key()) {
  case Qt::Key_Left:
  case Qt::Key_Up:
    move(chosen_, step);
    return;
  case Qt::Key_Right:
  case Qt::Key_Down:
    move(chosen_, -step);
    return;
  default:
    QWidget::keyPressEvent(event);
  }
}

void HueRing::focusInEvent(QFocusEvent* event) {
  if (event->reason() == Qt::TabFocusReason) {
    chosen_ = Part::From;
  } else if (event->reason() == Qt::BacktabFocusReason) {
    chosen_ = Part::Arc;
  }
  QWidget::focusInEvent(event);
}

bool HueRing::focusNextPrevChild(bool next) {
  constexpr Part kOrder[] = {Part::From, Part::To, Part::Arc};
  const auto* at = std::ranges::find(kOrder, chosen_);
  if (hasFocus() && (next ? at + 1 != std::end(kOrder) : at != std::begin(kOrder))) {
    chosen_ = next ? *(at + 1) : *(at - 1);
    Q_EMIT editingFinished();
    update();
    return true;
  }
  return QWidget::focusNextPrevChild(next);
}

const QImage& HueRing::wheel() {
  const double ratio = devicePixelRatioF();
  const QSize size = this->size() * ratio;
  if (wheel_.size() != size) {
    wheel_ = QImage(size, QImage::Format_ARGB32_Premultiplied);
    wheel_.setDevicePixelRatio(ratio);
    wheel_.fill(Qt::transparent);
    QPainter painter(&wheel_);
    painter.setRenderHint(QPainter::Antialiasing);
    const double middle = radius() - kThickness / 2.0;
    const QPointF center(width() / 2.0, height() / 2.0);
    for (int hue = 0; hue < 360; ++hue) {
      painter.setPen(QPen(QColor::fromHsvF(static_cast<float>(hue) / 360.0F, 0.85F, 0.92F),
                          kThickness, Qt::SolidLine, Qt::FlatCap));
      painter.drawArc(QRectF(center - QPointF(middle, middle), 2.0 * QSizeF(middle, middle)),
                      hue * 16, 24);
    }
  }
  return wheel_;
}

void HueRing::paintHistogram(QPainter& painter) const {
  if (histogram_.empty()) {
    return;
  }
  const double most = *std::ranges::max_element(histogram_);
  const double outer = radius() - kThickness - 4.0;
  const double reach = outer * 0.55;
  painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 1.0));
  for (std::size_t i = 0; most > 0.0 && i < histogram_.size(); ++i) {
    const double hue = kFull * (static_cast<double>(i) + 0.5) / double(histogram_.size());
    // A root, or the desk would hide everything else.
    const double length = reach * std::sqrt(histogram_[i] / most);
    painter.drawLine(pointAt(hue, outer), pointAt(hue, outer - length));
  }
}

void HueRing::paintRange(QPainter& painter) const {
  const double wide = dewpoint::ui::width(from_, to_);
  const double outside = radius() + 3.0;
  const QPointF center(width() / 2.0, height() / 2.0);
  // What is outside of the range steps back.
  QColor veil = palette().color(QPalette::Window);
  veil.setAlphaF(0.72F);
  const double middle = radius() - kThickness / 2.0;
  painter.setPen(QPen(veil, kThickness + 2.0, Qt::SolidLine, Qt::FlatCap));
  painter.drawArc(QRectF(center - QPointF(middle, middle), 2.0 * QSizeF(middle, middle)),
                  static_cast<int>(16.0 * to_), static_cast<int>(16.0 * (kFull - wide)));
  const bool focus = hasFocus();
  const QColor accent = palette().color(QPalette::Highlight);
  painter.setPen(
      QPen(focus && chosen_ == Part::Arc ? accent : palette().color(QPalette::Text), 2.0));
  painter.drawArc(QRectF(center - QPointF(outside, outside), 2.0 * QSizeF(outside, outside)),
                  static_cast<int>(16.0 * from_), static_cast<int>(16.0 * wide));
  for (const auto& [hue, part] : {std::pair(from_, Part::From), std::pair(to_, Part::To)}) {
    painter.setPen(QPen(focus && chosen_ == part ? accent : palette().color(QPalette::Text), 2.0));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawEllipse(pointAt(hue, middle), kRingHandle, kRingHandle);
  }
}

void HueRing::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setOpacity(isEnabled() ? 1.0 : 0.4);
  painter.drawImage(QPointF(0.0, 0.0), wheel());
  paintHistogram(painter);
  paintRange(painter);
}

} // namespace dewpoint::ui
