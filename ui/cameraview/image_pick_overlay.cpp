// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/image_pick_overlay.h"

#include "core/session/snapshot/snapshot.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/loupe.h"
#include "ui/cameraview/pick_marks.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace dewpoint::ui {

namespace {

constexpr double kStepsAcross = 64.0; ///< of an arrow key, over the width of the image
constexpr double kLoupeBelow = 4.0;   ///< widget units per pixel: smaller ones are enlarged

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
  const bool looksTheSame = picking == picking_ && !cross_;
  picking_ = picking;
  cross_.reset();
  if (pointing_) {
    pressed_.reset();
  }
  if (!looksTheSame) {
    update();
  }
  setCursor(picking ? Qt::CrossCursor : Qt::ArrowCursor);
  setMouseTracking(picking && magnifying_);
  if (!picking) {
    pointer_.reset();
  }
}

void ImagePickOverlay::setGuides(std::vector<QPolygonF> lines, std::optional<QPointF> point) {
  if (lines != guideLines_ || point != guidePoint_) {
    guideLines_ = std::move(lines);
    guidePoint_ = point;
    update();
  }
}

void ImagePickOverlay::endPointing() {
  if (pointing_) {
    Q_EMIT dragEnded();
  }
}

void ImagePickOverlay::setRegions(std::vector<Region> regions) {
  if (regions != regions_) {
    regions_ = std::move(regions);
    update();
  }
}

QPointF ImagePickOverlay::nearestPixel(QPointF position) const {
  const QSize image = view_->imageSize();
  const QPointF pixel = view_->placement().pixelAt(position);
  return {std::clamp(pixel.x(), -0.5, image.width() - 0.5),
          std::clamp(pixel.y(), -0.5, image.height() - 0.5)};
}

void ImagePickOverlay::mousePressEvent(QMouseEvent* event) {
  const bool sample = event->modifiers() & (Qt::ShiftModifier | Qt::AltModifier);
  const auto pixel = view_->pixelAt(event->position());
  if (event->button() != Qt::LeftButton || !pixel) {
    return;
  }
  cross_.reset();
  Q_EMIT viewChosen();
  if (picking_ || sample) {
    pressed_ = Press{event->position(), *pixel};
    pointerPosition_ = event->position();
    if (pointing_) {
      update();
      Q_EMIT pointGrabbed(*pixel);
      Q_EMIT pointMoved(*pixel);
    }
  } else {
    panned_ = event->position();
    Q_EMIT imageClicked(*pixel);
  }
}

void ImagePickOverlay::mouseMoveEvent(QMouseEvent* event) {
  if (picking_ && magnifying_) {
    pointer_ = event->position();
    update();
  }
  if (pressed_) {
    pointerPosition_ = event->position();
    update();
    if (pointing_) {
      Q_EMIT pointMoved(nearestPixel(pointerPosition_));
    }
  } else if (panned_ && event->buttons().testFlag(Qt::LeftButton)) {
    view_->panBy(event->position() - *std::exchange(panned_, event->position()));
  }
}

void ImagePickOverlay::mouseReleaseEvent(QMouseEvent* event) {
  panned_.reset();
  if (!pressed_ || event->button() != Qt::LeftButton) {
    return;
  }
  const Press from = *std::exchange(pressed_, std::nullopt);
  update();
  const QPointF last = nearestPixel(event->position()); // a box may be drawn beyond the edge
  if (pointing_) {
    Q_EMIT picked(QRectF(last, QSizeF(0.0, 0.0)), event->modifiers());
    endPointing();
    return;
  }
  const bool isBox = (event->position() - from.position).manhattanLength() >=
                     2 * QApplication::startDragDistance();
  Q_EMIT picked(isBox ? QRectF(from.pixel, last).normalized()
                      : QRectF(from.pixel, QSizeF(0.0, 0.0)),
                event->modifiers());
}

void ImagePickOverlay::mouseDoubleClickEvent(QMouseEvent* event) {
  const bool isTool =
      picking_ || event->modifiers() & (Qt::ShiftModifier | Qt::AltModifier); // two clicks of it
  if (event->button() == Qt::LeftButton && !isTool && view_->isZoomed()) {
    view_->fitImage();
  } else {
    mousePressEvent(event);
  }
}

void ImagePickOverlay::contextMenuEvent(QContextMenuEvent* event) {
  if (event->reason() == QContextMenuEvent::Keyboard && cross_) {
    view_->requestMenu(view_->placement().positionOf(*cross_));
  } else {
    event->ignore(); // the view opens it
  }
}

void ImagePickOverlay::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  pointer_.reset();
  update();
}

void ImagePickOverlay::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && pressed_) {
    pressed_.reset();
    update();
    endPointing();
    return;
  }
  if (event->key() == Qt::Key_Escape && picking_) {
    Q_EMIT canceled();
    return;
  }
  if (!controlsCross(*event)) {
    QWidget::keyPressEvent(event);
    return;
  }
  const bool points = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (points && cross_) {
    Q_EMIT viewChosen();
    Q_EMIT picked(QRectF(*cross_, QSizeF(0.0, 0.0)), event->modifiers() & ~Qt::KeypadModifier);
  } else {
    moveCross(event->key(), event->modifiers().testFlag(Qt::ControlModifier));
  }
}

bool ImagePickOverlay::controlsCross(const QKeyEvent& event) const {
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
  QPointF middle((image.width() - 1) / 2.0, (image.height() - 1) / 2.0);
  double across = image.width();
  if (view_->isZoomed()) { // what is seen is crossed in as many steps
    middle = view_->placement().pixelAt(view_->shownArea().center());
    across = view_->shownArea().width() / view_->placement().scale;
  }
  const double step = fine ? 1.0 : std::max(1.0, std::round(across / kStepsAcross));
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
  pointer_.reset(); // the keys are in use now
  view_->reveal(*cross_);
  update();
  if (pointing_ && moves) {
    Q_EMIT pointMoved(*cross_);
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
  if (event->type() == QEvent::ShortcutOverride && controlsCross(*static_cast<QKeyEvent*>(event))) {
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

void ImagePickOverlay::paintMagnified(QPainter& painter) const {
  const FramePtr& frame = view_->shownFrame();
  const ImagePlacement& placement = view_->placement();
  if (!picking_ || !magnifying_ || !frame || frame->image.type() != CV_8UC3 ||
      placement.scale >= kLoupeBelow) {
    return;
  }
  const std::optional<QPointF> at =
      cross_ && !pointer_ ? std::optional(placement.positionOf(*cross_)) : pointer_;
  const std::optional<QPointF> pixel = at ? view_->pixelAt(*at) : std::nullopt;
  const QRectF place = pixel ? loupeRect(*at, size()) : QRectF();
  if (!place.isEmpty()) {
    paintLoupe(painter, place, frame->image, *pixel, *pixel);
  }
}

void ImagePickOverlay::paintEvent(QPaintEvent*) {
  const bool hints = picking_ && !hint_.isEmpty() && !view_->imageSize().isEmpty();
  const bool guides = !guideLines_.empty() || guidePoint_;
  if (!pressed_ && !cross_ && !pointer_ && regions_.empty() && !hints && !guides) {
    return;
  }
  const ImagePlacement& placement = view_->placement();
  const auto placed = [&](const QPolygonF& pixels) {
    QPolygonF positions;
    for (const QPointF& pixel : pixels) {
      positions << placement.positionOf(pixel);
    }
    return positions;
  };
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  if (guides) {
    painter.save();
    painter.setClipRect(view_->shownArea());
    for (const QPolygonF& line : guideLines_) {
      paintPickGuide(painter, placed(line));
    }
    if (guidePoint_) {
      paintPickCross(painter, placement.positionOf(*guidePoint_));
    }
    painter.restore();
  }
  if (hints) {
    paintPickHint(painter, hint_, view_->shownArea());
  }
  if (pressed_ && pointing_) {
    paintPickCross(painter, placement.positionOf(nearestPixel(pointerPosition_)));
  } else if (pressed_) {
    const QRectF box(placement.positionOf(pressed_->pixel), pointerPosition_);
    paintPickOutline(painter, QPolygonF(box.normalized()), Qt::DashLine);
  }
  if (cross_) {
    paintPickCross(painter, placement.positionOf(*cross_));
  }
  for (const Region& region : regions_) {
    paintPickRegion(painter, placed(region.outline), region.text, size());
  }
  paintMagnified(painter);
}

} // namespace dewpoint::ui
