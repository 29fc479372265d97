// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/manual/interactive_pose.h"
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/window_fixture.h"
#include "ui/calibration/manual/grid_layer.h"
#include "ui/calibration/manual/grid_painter.h"
#include "ui/cameraview/camera_view.h"
#include "ui/document/document.h"

#include <QMouseEvent>
#include <QUndoStack>

#include <vector>

namespace dewpoint::tests::test {

/// The window with the demo, paused, and its calibration place open; mouse and keys for it.
class CalibrationWindow : protected WindowFixture {
protected:
  const Project& project() { return window_->document().project(); }
  Camera camera(int k) { return project().cameras[static_cast<std::size_t>(k)].camera; }
  QUndoStack& history() { return *window_->document().undoStack(); }
  GridLayer* layer(int k) { return find<GridLayer>(QStringLiteral("gridLayer%1").arg(k)); }
  /// Where a camera's pixel is in its layer.
  QPointF placed(int k, const Eigen::Vector2d& pixel) {
    return widgetPosition(pixel, static_cast<CameraView*>(layer(k)->parentWidget())->placement());
  }

  void openCalibration();
  void mouse(int k, QEvent::Type type, const Eigen::Vector2d& pixel,
             Qt::KeyboardModifiers modifiers = {});
  void drag(int k, const Eigen::Vector2d& from, const Eigen::Vector2d& to);
  void click(int k, const Eigen::Vector2d& pixel, Qt::KeyboardModifiers modifiers = {});
  /// Crossings of the standard grid well inside the image of a camera.
  std::vector<Eigen::Vector3d> crossings(int k);
  Eigen::Vector2d seen(int k, const Eigen::Vector3d& world) {
    return Projector(camera(k)).project(world).value();
  }

  ReferenceGrid grid_; ///< what is laid over the images
};

inline void CalibrationWindow::openCalibration() {
  makeWindow({.size = {1500, 950}, .theme = Theme::Light, .play = false});
  open();
  QVERIFY(waitFor([this] { return shown().iterationCount > 0; }));
  CameraRig rig;
  for (const ProjectCamera& one : project().cameras) {
    rig.push_back(one.camera);
  }
  grid_ = referenceGridFor(rig);
  QTest::keyClick(window_.get(), Qt::Key_C);
  const auto* view = static_cast<CameraView*>(layer(0)->parentWidget());
  QVERIFY(waitFor([view] { return !view->imageSize().isEmpty(); }));
  QVERIFY(keepsItsSize(layer(0)));
}

inline void CalibrationWindow::mouse(int k, QEvent::Type type, const Eigen::Vector2d& pixel,
                                     Qt::KeyboardModifiers modifiers) {
  // By event: QTest knows whole pixels only, mice know parts.
  const QPointF at = placed(k, pixel);
  const bool moves = type == QEvent::MouseMove;
  const bool down = type != QEvent::MouseButtonRelease;
  QMouseEvent event(type, at, layer(k)->mapToGlobal(at), moves ? Qt::NoButton : Qt::LeftButton,
                    down ? Qt::LeftButton : Qt::NoButton, modifiers);
  QApplication::sendEvent(layer(k), &event);
}

inline void CalibrationWindow::drag(int k, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  mouse(k, QEvent::MouseButtonPress, from);
  for (int step = 1; step <= 8; ++step) {
    mouse(k, QEvent::MouseMove, from + step / 8.0 * (to - from));
  }
  mouse(k, QEvent::MouseButtonRelease, to);
  QCoreApplication::processEvents(); // what the release has queued
}

inline void CalibrationWindow::click(int k, const Eigen::Vector2d& pixel,
                                     Qt::KeyboardModifiers modifiers) {
  mouse(k, QEvent::MouseButtonPress, pixel, modifiers);
  mouse(k, QEvent::MouseButtonRelease, pixel, modifiers);
}

inline std::vector<Eigen::Vector3d> CalibrationWindow::crossings(int k) {
  const ReferenceGrid& grid = grid_;
  const Projector projector(camera(k));
  const Intrinsics& in = camera(k).intrinsics;
  std::vector<Eigen::Vector3d> found;
  for (double x = 0.0; x <= grid.size.x() + 1e-9; x += grid.step) {
    for (double y = 0.0; y <= grid.size.y() + 1e-9; y += grid.step) {
      const Eigen::Vector3d world = grid.origin + Eigen::Vector3d(x, y, 0.0);
      const auto at = projector.project(world);
      if (at && at->x() > 40 && at->y() > 40 && at->x() < in.width - 40 &&
          at->y() < in.height - 40) {
        found.push_back(world);
      }
    }
  }
  return found;
}

} // namespace dewpoint::tests::test
