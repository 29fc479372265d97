// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/wiring/open_project.h"
#include "core/capture/frame_writer.h"
#include "core/session/run/snapshot.h"
#include "core/setup/new_project.h"
#include "tests/tracking/moving_patch.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_pick_overlay.h"
#include "ui/document/document.h"
#include "ui/mainwindow/main_window.h"

#include <QAction>
#include <QLabel>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <functional>
#include <memory>

namespace dewpoint::tests {

/// The window with one video without a calibration, 320 x 240, that shows a moving patch.
class BoxWindow {
protected:
  static constexpr int kPatienceMs = DEWPOINT_PATIENCE_MS;
  static constexpr int kFrames = 40;

  void record() {
    video_ = folder_.filePath("patch.mkv").toStdString();
    auto writer = FrameWriter::video(video_.string(), 25.0);
    QVERIFY(writer);
    for (int frame = 0; frame < kFrames; ++frame) {
      QVERIFY(writer->write(MovingPatch{}.image(frame)));
    }
    QVERIFY(writer->finish());
  }
  void open() {
    QSettings().clear();
    window_ = std::make_unique<MainWindow>(&openProject);
    window_->resize(1400, 900);
    window_->setPlayOnOpen(false);
    window_->show();
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  }
  void close() { window_.reset(); }

  template <class T> T* find(const char* name) {
    T* found = window_->findChild<T*>(QLatin1String(name));
    if (found == nullptr) {
      qFatal("no child named %s", name);
    }
    return found;
  }
  bool waitFor(const std::function<bool()>& holds) { return QTest::qWaitFor(holds, kPatienceMs); }
  QAction* action(const char* id) { return find<QAction>(id); }
  /// Opens the video as the page for new projects would, paused.
  void openVideo() {
    NewProject wanted;
    wanted.cameras = {{"", SourceKind::Video, video_.string()}};
    const auto made = makeProject(wanted);
    QVERIFY(made);
    const auto file = folder_.filePath("one.toml").toStdString();
    QVERIFY(saveProject(made->project, file));
    window_->openProject(file);
    QVERIFY(waitFor([this] { return window_->shown() && window_->shown()->frame == 0; }));
    auto* view = find<CameraView>("cameraView0");
    QVERIFY(waitFor([&] { return !view->imageSize().isEmpty() && view->height() > 100; }));
    QTest::qWait(300); // the layout settles
  }
  QPoint placeOf(const Eigen::Vector2d& pixel) {
    const ImagePlacement& placement = find<CameraView>("cameraView0")->placement();
    return (placement.corner + QPointF(pixel.x(), pixel.y()) * placement.scale).toPoint();
  }
  void clickAt(const Eigen::Vector2d& pixel) {
    QTest::mouseClick(find<ImagePickOverlay>("cameraView0Pick"), Qt::LeftButton, Qt::NoModifier,
                      placeOf(pixel));
  }
  void dragTo(const QPoint& from, const QPoint& to) {
    auto* layer = find<ImagePickOverlay>("cameraView0Pick");
    QTest::mousePress(layer, Qt::LeftButton, Qt::NoModifier, from);
    QTest::mouseMove(layer, (from + to) / 2);
    QTest::mouseRelease(layer, Qt::LeftButton, Qt::NoModifier, to);
  }
  bool isTrackedTo(std::int64_t frame) {
    return waitFor([&] { return window_->shown() && window_->shown()->history.head >= frame; });
  }
  std::size_t targetCount() { return window_->document().project().targets.size(); }
  const TargetSnapshot* first() const {
    const auto shown = window_->shown();
    return shown && !shown->targets.empty() ? &shown->targets.front() : nullptr;
  }
  bool hasBox() const { return first() != nullptr && first()->box.has_value(); }
  QString message() { return find<QLabel>("messageText")->text(); }

  QTemporaryDir folder_;
  std::filesystem::path video_;
  std::unique_ptr<MainWindow> window_;
};

} // namespace dewpoint::tests
