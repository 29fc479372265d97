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

/// Rendered image of a scene for a view. It is drawn at its own rate: at most about 15 times per
/// second, using at most half of the time of one processor. Without OpenGL, there is no image, and
/// `failureReason()` gives the reason.
class ScenePicture : public QObject {
  Q_OBJECT
public:
  ScenePicture(Scene3d& scene, QWidget& view);
  ~ScenePicture() override;

  /// Creates the OpenGL context and renders once while hidden, so that the first visible image
  /// appears without delay.
  void prepareFirstImage();
  /// Marks the image as outdated. The image is redrawn soon, or when the view becomes visible.
  void requestRendering();
  /// Renders the image immediately.
  void render();

  /// Returns the image, or null if nothing has been rendered.
  const QImage& image() const { return image_; }
  /// Returns whether the image has the size of the view.
  bool hasSizeOfView() const;
  /// Returns whether the image is outdated.
  bool isStale() const { return stale_; }
  bool isUpToDate() const { return !stale_ && !timer_.isActive(); }
  /// Returns the reason why there is no 3D view; empty if the view works, and before the first
  /// attempt to draw.
  const std::string& failureReason() const { return failure_; }

  /// Passes a mouse event to the trackball camera. `position` is in view coordinates.
  void passPointerEvent(OffscreenVtk::PointerEvent what, QPointF position, bool shift);

Q_SIGNALS:
  /// Emitted before the image is rendered. The receiver must now update the scene.
  void aboutToRender();
  /// Emitted after the image was rendered.
  void rendered();
  /// Emitted if there is no usable OpenGL.
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
  qint64 renderMs_ = 0; ///< duration of the last rendering
  bool started_ = false;
  bool stale_ = true;
};

} // namespace dewpoint::ui
