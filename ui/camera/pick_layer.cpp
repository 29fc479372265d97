// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/camera/pick_layer.h"

#include "ui/camera/camera_view.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

namespace dewpoint {

namespace {

/// Bright on a dark halo: readable on any image.
void stroke(QPainter& painter, const QPolygonF& outline, Qt::PenStyle style) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, 170), 3.0));
  painter.drawPolygon(outline);
  painter.setPen(QPen(QColor("#f0e442"), 1.4, style));
  painter.drawPolygon(outline);
}

} // namespace

PickLayer::PickLayer(CameraView* view) : QWidget(view), view_(view) {
  setObjectName(view->objectName() + QStringLiteral("Pick"));
  setGeometry(view->rect());
  view->installEventFilter(this);
}

bool PickLayer::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_ && event->type() == QEvent::Resize) {
    setGeometry(view_->rect());
  }
  return false;
}

void PickLayer::setPicking(bool picking) {
  picking_ = picking;
  setCursor(picking ? Qt::CrossCursor : Qt::ArrowCursor);
}

void PickLayer::setRegions(std::vector<Region> regions) {
  regions_ = std::move(regions);
  update();
}

std::optional<QPointF> PickLayer::pixelAt(QPointF position) const {
  const QSize image = view_->imageSize();
  const ImagePlacement& placement = view_->placement();
  // Centers of pixels lie at whole numbers.
  const QPointF pixel = (position - placement.corner) / placement.scale - QPointF(0.5, 0.5);
  const bool inside = pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < image.width() - 0.5 &&
                      pixel.y() < image.height() - 0.5;
  return inside ? std::optional(pixel) : std::nullopt;
}

QPointF PickLayer::positionOf(QPointF pixel) const {
  const ImagePlacement& placement = view_->placement();
  return placement.corner + (pixel + QPointF(0.5, 0.5)) * placement.scale;
}

void PickLayer::mousePressEvent(QMouseEvent* event) {
  const bool sample = event->modifiers() & (Qt::ShiftModifier | Qt::AltModifier);
  if (event->button() != Qt::LeftButton || !pixelAt(event->position())) {
    return;
  }
  Q_EMIT chosen();
  if (picking_ || sample) {
    pressed_ = event->position();
    now_ = event->position();
  }
}

void PickLayer::mouseMoveEvent(QMouseEvent* event) {
  if (pressed_) {
    now_ = event->position();
    update();
  }
}

void PickLayer::mouseReleaseEvent(QMouseEvent* event) {
  if (!pressed_) {
    return;
  }
  const QPointF from = *std::exchange(pressed_, std::nullopt);
  update();
  const auto first = pixelAt(from);
  const auto last = pixelAt(event->position()).value_or(first.value_or(QPointF()));
  if (!first) {
    return;
  }
  const bool isBox =
      (event->position() - from).manhattanLength() >= 2 * QApplication::startDragDistance();
  Q_EMIT picked(isBox ? QRectF(*first, last).normalized() : QRectF(*first, QSizeF(0.0, 0.0)),
                event->modifiers());
}

void PickLayer::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && pressed_) {
    pressed_.reset();
    update();
    return;
  }
  QWidget::keyPressEvent(event);
}

void PickLayer::paintEvent(QPaintEvent*) {
  if (!pressed_ && regions_.empty()) {
    return;
  }
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (pressed_) {
    stroke(painter, QPolygonF(QRectF(*pressed_, now_).normalized()), Qt::DashLine);
  }
  for (const Region& region : regions_) {
    QPolygonF outline;
    for (const QPointF& pixel : region.outline) {
      outline << positionOf(pixel);
    }
    stroke(painter, outline, Qt::SolidLine);
    const QRectF box = outline.boundingRect();
    const QRectF text =
        painter.fontMetrics().boundingRect(region.text).toRectF().adjusted(-4, -2, 4, 2);
    QRectF label(box.topLeft() - QPointF(0.0, text.height() + 2.0), text.size());
    label.moveLeft(std::clamp(label.left(), 0.0, std::max(0.0, width() - label.width())));
    label.moveTop(std::max(0.0, label.top()));
    painter.fillRect(label, QColor(0, 0, 0, 170));
    painter.setPen(QColor("#f0e442"));
    painter.drawText(label, Qt::AlignCenter, region.text);
  }
}

} // namespace dewpoint
