// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/scene3d/scene3d.h"
#include "ui/view3d/offscreen_vtk.h"

#include <QElapsedTimer>
#include <QImage>
#include <QObject>
#include <QPointF>
#include <QTimer>

#include <memory>
#include <string>

class QWidget;

namespace dewpoint::ui {

/// The picture of a scene for a view, drawn at its own rate: at most about 15 times a second, and
/// never for more than half of one processor's time. Without OpenGL there is none, and a reason.
class ScenePicture : public QObject {
  Q_OBJECT
public:
  ScenePicture(Scene3d& scene, QWidget& view);
  ~ScenePicture() override;

  /// Makes the OpenGL context and draws once, unseen: what the first picture would be waited for.
  void prepare();
  /// It shows no more what it should: draws it soon, or when the view is shown.
  void request();
  /// Draws it now.
  void render();

  /// Null: there is none yet, or never.
  const QImage& image() const { return image_; }
  /// Whether it is of the view's size.
  bool fits() const;
  /// Whether it does not show all that was given last.
  bool isStale() const { return stale_; }
  bool isUpToDate() const { return !stale_ && !timer_.isActive(); }
  /// Why there is no 3D (known after the first attempt to draw); empty while there is.
  const std::string& failure() const { return failure_; }

  /// What the mouse does to the trackball camera; `position` in the view.
  void movePointer(OffscreenVtk::Pointer what, QPointF position, bool shift);

Q_SIGNALS:
  /// It is drawn next: the scene has to be up to date.
  void drawing();
  /// It is new.
  void drawn();
  /// There is no usable OpenGL.
  void unavailable();

private:
  void start();
  QSize size() const;

  Scene3d& scene_;
  QWidget& view_;
  std::unique_ptr<OffscreenVtk> vtk_;
  QImage image_;
  std::string failure_;
  QTimer timer_;
  QElapsedTimer sinceDrawn_;
  qint64 costMs_ = 0; ///< of the last one
  bool started_ = false;
  bool stale_ = true;
};

} // namespace dewpoint::ui
