// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/frame_writer.h"
#include "core/project/project_save.h"
#include "core/session/snapshot/snapshot.h"
#include "core/setup/new_project/new_project.h"
#include "tests/tracking/moving_patch.h"
#include "tests/ui/window_fixture.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_pick_overlay.h"
#include "ui/document/document.h"

namespace dewpoint::tests {

/// The window with one video without a calibration, 320 x 240, that shows a moving patch.
class BoxWindow : protected test::WindowFixture {
protected:
  static constexpr int kFrames = 40;

  void record() {
    video_ = path("patch.mkv");
    auto writer = FrameWriter::createVideo(video_.string(), 25.0);
    QVERIFY(writer);
    for (int frame = 0; frame < kFrames; ++frame) {
      QVERIFY(writer->write(MovingPatch{}.image(frame)));
    }
    QVERIFY(writer->finish());
  }
  void open() { makeWindow({.size = {1400, 900}, .play = false}); }
  void close() { window_.reset(); }
  /// Opens the video as the page for new projects would, paused.
  void openVideo() {
    NewProject wanted;
    wanted.cameras = {{"", SourceKind::Video, video_.string()}};
    const auto made = createNewProject(wanted);
    QVERIFY(made);
    QVERIFY(saveProject(made->project, path("one.toml")));
    window_->openProject(path("one.toml"));
    QVERIFY(waitFor([this] { return window_->shown() && window_->shown()->frame == 0; }));
    auto* view = find<CameraView>("cameraView0");
    QVERIFY(waitFor([&] { return !view->imageSize().isEmpty() && view->height() > 100; }));
    QVERIFY(keepsItsSize(view));
  }
  QPoint placeOf(const Eigen::Vector2d& pixel) {
    const ImagePlacement& placement = find<CameraView>("cameraView0")->placement();
    return (placement.topLeft + QPointF(pixel.x(), pixel.y()) * placement.scale).toPoint();
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
    return waitFor(
        [&] { return window_->shown() && window_->shown()->history.newestTrackedFrame >= frame; });
  }
  std::size_t targetCount() { return window_->document().project().targets.size(); }
  const TargetSnapshot* first() const {
    const auto shown = window_->shown();
    return shown && !shown->targets.empty() ? &shown->targets.front() : nullptr;
  }
  bool hasBox() const { return first() != nullptr && first()->box() != nullptr; }

  std::filesystem::path video_;
};

} // namespace dewpoint::tests
