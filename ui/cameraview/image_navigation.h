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

/// The wheel and the middle button in a camera view, whatever lies over its image: the wheel zooms
/// at the pointer, a drag with the middle button, or with the left one and Ctrl, moves a zoomed
/// image. What it takes never reaches the tools over the image.
class ImageNavigation : public QObject {
  Q_OBJECT
public:
  /// Belongs to the view.
  explicit ImageNavigation(CameraView* view);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  bool zoom(QWidget* under, QWheelEvent& event);
  bool press(QWidget* under, QMouseEvent& event);
  bool move(QWidget* under, QMouseEvent& event);
  bool release(QWidget* under, QMouseEvent& event);

  CameraView* view_;
  std::optional<QPointF> dragged_; ///< where the pointer was last, in the view
  Qt::MouseButton button_ = Qt::NoButton;
  QCursor cursor_; ///< before the drag
};

} // namespace dewpoint::ui
