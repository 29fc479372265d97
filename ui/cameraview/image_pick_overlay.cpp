// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/image_pick_overlay.h"

#include "ui/cameraview/camera_view.h"
#include "ui/style/halo.h"

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::ui {

namespace {

constexpr double kStepsAcross = 64.0; ///< of an arrow key, over the width of the image
constexpr double kArm = 14.0;         ///< of the cross, widget pixels

constexpr QColor kStrokeColor(0xf0, 0xe4, 0x42);

void stroke(QPainter& painter, const QPolygonF& outline, Qt::PenStyle style) {
  withHalo(
      painter, kStrokeColor, 1.4, [&] { painter.drawPolygon(outline); }, style, edgeHalo(170, 1.6));
}

} // namespace

ImagePickOverlay::ImagePickOverlay(CameraView* view) : QWidget(view), view_(view) {
  setObjectName(view->objectName() + QStringLiteral("Pick"));
  setGeometry(view->rect());
  setFocusPolicy(Qt::StrongFocus);
  view->installEventFilter(this);
}

bool ImagePickOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_ && event->type() == QEvent::Resize) {
    setGeometry(view_->rect());
  }
  return false;
}

void ImagePickOverlay::setPicking(bool picking) {
  picking_ = picking;
  cross_.reset();
  if (pointing_) {
    pressed_.reset();
  }
  update();
  setCursor(picking ? Qt::CrossCursor : Qt::ArrowCursor);
}

void ImagePickOverlay::setGuides(std::vector<QPolygonF> lines, std::optional<QPointF> point) {
  guideLines_ = std::move(lines);
  guidePoint_ = point;
  update();
}

void ImagePickOverlay::endPointing() {
  if (pointing_) {
    Q_EMIT pointingEnded();
  }
}

void ImagePickOverlay::setRegions(std::vector<Region> regions) {
  regions_ = std::move(regions);
  update();
}

QPointF ImagePickOverlay::pixelOf(QPointF position) const {
  const ImagePlacement& placement = view_->placement();
  // Centers of pixels lie at whole numbers.
  return (position - placement.corner) / placement.scale - QPointF(0.5, 0.5);
}

QPointF ImagePickOverlay::nearestPixel(QPointF position) const {
  const QSize image = view_->imageSize();
  const QPointF pixel = pixelOf(position);
  return {std::clamp(pixel.x(), -0.5, image.width() - 0.5),
          std::clamp(pixel.y(), -0.5, image.height() - 0.5)};
}

std::optional<QPointF> ImagePickOverlay::pixelAt(QPointF position) const {
  const QSize image = view_->imageSize();
  const QPointF pixel = pixelOf(position);
  const bool inside = pixel.x() >= -0.5 && pixel.y() >= -0.5 && pixel.x() < image.width() - 0.5 &&
                      pixel.y() < image.height() - 0.5;
  return inside ? std::optional(pixel) : std::nullopt;
}

QPointF ImagePickOverlay::positionOf(QPointF pixel) const {
  const ImagePlacement& placement = view_->placement();
  return placement.corner + (pixel + QPointF(0.5, 0.5)) * placement.scale;
}

void ImagePickOverlay::mousePressEvent(QMouseEvent* event) {
  const bool sample = event->modifiers() & (Qt::ShiftModifier | Qt::AltModifier);
  if (event->button() != Qt::LeftButton || !pixelAt(event->position())) {
    return;
  }
  cross_.reset();
  Q_EMIT chosen();
  if (picking_ || sample) {
    pressed_ = event->position();
    now_ = event->position();
    if (pointing_) {
      update();
      Q_EMIT grabbed(*pixelAt(now_));
      Q_EMIT pointed(*pixelAt(now_));
    }
  } else {
    Q_EMIT imageClicked(*pixelAt(event->position()));
  }
}

void ImagePickOverlay::mouseMoveEvent(QMouseEvent* event) {
  if (pressed_) {
    now_ = event->position();
    update();
    if (pointing_) {
      Q_EMIT pointed(nearestPixel(now_));
    }
  }
}

void ImagePickOverlay::mouseReleaseEvent(QMouseEvent* event) {
  if (!pressed_) {
    return;
  }
  const QPointF from = *std::exchange(pressed_, std::nullopt);
  update();
  const auto first = pixelAt(from);
  if (!first) {
    return;
  }
  const QPointF last = nearestPixel(event->position()); // a box may be drawn beyond the edge
  if (pointing_) {
    Q_EMIT picked(QRectF(last, QSizeF(0.0, 0.0)), event->modifiers());
    endPointing();
    return;
  }
  const bool isBox =
      (event->position() - from).manhattanLength() >= 2 * QApplication::startDragDistance();
  Q_EMIT picked(isBox ? QRectF(*first, last).normalized() : QRectF(*first, QSizeF(0.0, 0.0)),
                event->modifiers());
}

void ImagePickOverlay::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && pressed_) {
    pressed_.reset();
    update();
    endPointing();
    return;
  }
  if (event->key() == Qt::Key_Escape && picking_) {
    Q_EMIT cancelled();
    return;
  }
  if (!isForCross(*event)) {
    QWidget::keyPressEvent(event);
    return;
  }
  const bool points = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (points && cross_) {
    Q_EMIT chosen();
    Q_EMIT picked(QRectF(*cross_, QSizeF(0.0, 0.0)), event->modifiers() & ~Qt::KeypadModifier);
  } else {
    moveCross(event->key(), event->modifiers().testFlag(Qt::ControlModifier));
  }
}

bool ImagePickOverlay::isForCross(const QKeyEvent& event) const {
  switch (event.key()) {
  case Qt::Key_Left:
  case Qt::Key_Right:
  case Qt::Key_Up:
  case Qt::Key_Down:
    return picking_ && !view_->imageSize().isEmpty();
  case Qt::Key_Return:
  case Qt::Key_Enter:
    return cross_.has_value();
  default:
    return false;
  }
}

void ImagePickOverlay::moveCross(int key, bool fine) {
  const QSize image = view_->imageSize();
  const QPointF middle((image.width() - 1) / 2.0, (image.height() - 1) / 2.0);
  const double step = fine ? 1.0 : std::max(1.0, std::round(image.width() / kStepsAcross));
  QPointF next = cross_.value_or(
      crossStart_.value_or(QPointF(std::floor(middle.x()), std::floor(middle.y()))));
  const bool moves = cross_.has_value();
  if (moves) { // the first key only shows it
    next += QPointF(key == Qt::Key_Left    ? -step
                    : key == Qt::Key_Right ? step
                                           : 0.0,
                    key == Qt::Key_Up     ? -step
                    : key == Qt::Key_Down ? step
                                          : 0.0);
  }
  cross_ = QPointF(std::clamp(next.x(), 0.0, image.width() - 1.0),
                   std::clamp(next.y(), 0.0, image.height() - 1.0));
  update();
  if (pointing_ && moves) {
    Q_EMIT pointed(*cross_);
  }
}

void ImagePickOverlay::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  if (picking_ && event->reason() != Qt::MouseFocusReason && !view_->imageSize().isEmpty()) {
    moveCross(0, false); // shows where the keys are
  }
}

void ImagePickOverlay::focusOutEvent(QFocusEvent* event) {
  if (std::exchange(cross_, std::nullopt) && !pressed_) {
    endPointing();
  }
  update();
  QWidget::focusOutEvent(event);
}

bool ImagePickOverlay::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && isForCross(*static_cast<QKeyEvent*>(event))) {
    event->accept(); // else the arrows would travel in time
    return true;
  }
  return QWidget::event(event);
}

void ImagePickOverlay::setHint(const QString& hint) {
  if (hint_ != hint) {
    hint_ = hint;
    update();
  }
}

void ImagePickOverlay::paintHint(QPainter& painter) const {
  const QSizeF text = painter.fontMetrics().size(Qt::TextSingleLine, hint_);
  const QSizeF pill(text.width() + 24.0, text.height() + 10.0);
  const double bottom = std::min(positionOf(QPointF(0.0, view_->imageSize().height())).y(),
                                 static_cast<double>(height()));
  const QRectF place(QPointF((width() - pill.width()) / 2.0, bottom - pill.height() - 10.0), pill);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 190));
  painter.drawRoundedRect(place, pill.height() / 2.0, pill.height() / 2.0);
  painter.setPen(Qt::white);
  painter.drawText(place, Qt::AlignCenter, hint_);
}

void ImagePickOverlay::paintCross(QPainter& painter, QPointF position) const {
  for (const QPointF arm : {QPointF(kArm, 0.0), QPointF(0.0, kArm)}) {
    stroke(painter, QPolygonF({position - arm, position - 0.3 * arm}), Qt::SolidLine);
    stroke(painter, QPolygonF({position + 0.3 * arm, position + arm}), Qt::SolidLine);
  }
}

void ImagePickOverlay::paintGuides(QPainter& painter) const {
  for (const QPolygonF& line : guideLines_) {
    QPolygonF drawn;
    for (const QPointF& pixel : line) {
      drawn << positionOf(pixel);
    }
    withHalo(painter, kStrokeColor, 1.2, [&] { painter.drawPolyline(drawn); });
  }
  if (guidePoint_) {
    paintCross(painter, positionOf(*guidePoint_));
  }
}

void ImagePickOverlay::paintRegions(QPainter& painter) const {
  for (const Region& region : regions_) {
    QPolygonF outline;
    for (const QPointF& pixel : region.outline) {
      outline << positionOf(pixel);
    }
    stroke(painter, outline, Qt::SolidLine);
    if (region.text.isEmpty()) {
      continue;
    }
    const QRectF box = outline.boundingRect();
    const QRectF text =
        painter.fontMetrics().boundingRect(region.text).toRectF().adjusted(-4, -2, 4, 2);
    QRectF label(box.topLeft() - QPointF(0.0, text.height() + 2.0), text.size());
    label.moveLeft(std::clamp(label.left(), 0.0, std::max(0.0, width() - label.width())));
    label.moveTop(std::max(0.0, label.top()));
    painter.fillRect(label, QColor(0, 0, 0, 170));
    painter.setPen(kStrokeColor);
    painter.drawText(label, Qt::AlignCenter, region.text);
  }
}

void ImagePickOverlay::paintEvent(QPaintEvent*) {
  const bool hints = picking_ && !hint_.isEmpty() && !view_->imageSize().isEmpty();
  const bool guides = !guideLines_.empty() || guidePoint_;
  if (!pressed_ && !cross_ && regions_.empty() && !hints && !guides) {
    return;
  }
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (guides) {
    painter.save();
    painter.setClipRect(
        QRectF(view_->placement().corner, QSizeF(view_->imageSize()) * view_->placement().scale));
    paintGuides(painter);
    painter.restore();
  }
  if (hints) {
    paintHint(painter);
  }
  if (pressed_ && pointing_) {
    paintCross(painter, positionOf(nearestPixel(now_)));
  } else if (pressed_) {
    stroke(painter, QPolygonF(QRectF(*pressed_, now_).normalized()), Qt::DashLine);
  }
  if (cross_) {
    paintCross(painter, positionOf(*cross_));
  }
  paintRegions(painter);
}

} // namespace dewpoint::ui
