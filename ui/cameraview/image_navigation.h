// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QCursor>
#include <QObject>
#include <QPointF>

#include <optional>

class QMouseEvent;
class QWheelEvent;
class QWidget;

namespace dewpoint::ui {

class CameraView;

/// Lets the user zoom and move the image of a camera view, whichever overlay is on top. The wheel
/// zooms at the pointer. Dragging with the middle button, or with Ctrl and the left button, moves a
/// zoomed image. Overlays never receive these events.
class ImageNavigation : public QObject {
  Q_OBJECT
public:
  /// Creates the navigation as a child of the view.
  explicit ImageNavigation(CameraView* view);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  bool zoom(QWidget* under, QWheelEvent& event);
  bool press(QWidget* under, QMouseEvent& event);
  bool move(QWidget* under, QMouseEvent& event);
  bool release(QWidget* under, QMouseEvent& event);

  CameraView* view_;
  std::optional<QPointF> dragged_; ///< last pointer position during a drag, view coordinates
  Qt::MouseButton button_ = Qt::NoButton;
  QCursor cursor_; ///< cursor before the drag
};

} // namespace dewpoint::ui
