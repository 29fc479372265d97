// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cameraview/image_navigation.h"

#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_zoom.h"

#include <QChildEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>
#include <utility>

namespace dewpoint::ui {

namespace {

constexpr double kWheelNotch = 120.0; ///< of QWheelEvent::angleDelta()

} // namespace

ImageNavigation::ImageNavigation(CameraView* view) : QObject(view), view_(view) {
  view->installEventFilter(this);
}

bool ImageNavigation::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ChildAdded && watched == view_) {
    QObject* child = static_cast<QChildEvent*>(event)->child();
    if (child->isWidgetType()) {
      child->installEventFilter(this); // it lies over the image and takes the mouse
    }
    return false;
  }
  auto* under = static_cast<QWidget*>(watched);
  if (under != view_ && under->isWindow()) {
    return false; // a menu of it
  }
  switch (event->type()) {
  case QEvent::Wheel:
    return zoom(under, *static_cast<QWheelEvent*>(event));
  case QEvent::MouseButtonPress:
  case QEvent::MouseButtonDblClick:
    return press(under, *static_cast<QMouseEvent*>(event));
  case QEvent::MouseMove:
    return move(under, *static_cast<QMouseEvent*>(event));
  case QEvent::MouseButtonRelease:
    return release(under, *static_cast<QMouseEvent*>(event));
  default:
    return false;
  }
}

bool ImageNavigation::zoom(QWidget* under, QWheelEvent& event) {
  const double notches = event.angleDelta().y() / kWheelNotch;
  if (notches == 0.0 || view_->imageSize().isEmpty()) {
    return false;
  }
  view_->zoomBy(std::pow(ImageZoom::kZoomStep, notches), under->mapTo(view_, event.position()));
  event.accept();
  return true;
}

bool ImageNavigation::press(QWidget* under, QMouseEvent& event) {
  const bool drags = event.button() == Qt::MiddleButton ||
                     (event.button() == Qt::LeftButton && event.modifiers() == Qt::ControlModifier);
  if (!drags || dragged_ || !view_->isZoomed()) {
    return false;
  }
  dragged_ = under->mapTo(view_, event.position());
  button_ = event.button();
  cursor_ = under->cursor();
  under->setCursor(Qt::ClosedHandCursor);
  event.accept();
  return true;
}

bool ImageNavigation::move(QWidget* under, QMouseEvent& event) {
  if (!dragged_) {
    return false;
  }
  const QPointF now = under->mapTo(view_, event.position());
  view_->panBy(now - *std::exchange(dragged_, now));
  return true;
}

bool ImageNavigation::release(QWidget* under, QMouseEvent& event) {
  if (!dragged_ || event.button() != button_) {
    return false;
  }
  dragged_.reset();
  under->setCursor(cursor_);
  return true;
}

} // namespace dewpoint::ui
