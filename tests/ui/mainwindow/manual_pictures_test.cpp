// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of the manual's first steps and tutorials, made by following them in the real
// window: into the folder that DEWPOINT_MANUAL names (docs/images), or beside the test.
#include "core/calibration/formats/calibration_file.h"
#include "core/capture/frame_writer.h"
#include "core/session/snapshot/snapshot.h"
#include "core/simulation/scene/scene_catalog.h"
#include "core/simulation/scene/scene_renderer.h"
#include "tests/ui/mainwindow/small_picture.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/cameraview/camera_view.h"
#include "ui/cameraview/image_pick_overlay.h"
#include "ui/document/document.h"
#include "ui/export/view_picture.h"
#include "ui/selection/selection.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLabel>
#include <QPainter>
#include <QProcess>
#include <QPushButton>

#include <array>

namespace dewpoint::tests {

namespace {

constexpr qint64 kLargestPicture = 300 << 10; ///< bytes
constexpr QSize kWindowOfManual(1280, 800);
constexpr QSize kTallWindow(1280, 1000); ///< where a page has much to say

} // namespace

class ManualPicturesTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void initTestCase();
  void init();
  void cleanup() { window_.reset(); }
  void particlesCondense();
  void firstTenMinutes();
  void twoVideos();
  void gridByHand();
  void board();
  void wand();
  void oneCameraAndABox();
  void peopleInARoom();
  void severalTargets();
  void changingLight();

private:
  void save(const QImage& picture, const QString& name);
  /// The whole window, once nothing in it changes any more.
  void keep(const QString& name);
  /// Recordings of the first frames of a scene, and its calibration, as a user would have them.
  void record(Scene scene, std::int64_t frames);
  /// Opens what was recorded by the page New project.
  void openRecordings(bool calibrated);
  void pause();
  /// Tracks again what is of earlier settings.
  void trackAgain();
  void showFrame(qint64 frame); ///< paused
  /// Clicks a point of space, as a camera sees it.
  void clickAt(int camera, const Eigen::Vector3d& world);
  /// A camera's image with what is drawn over it, cut to the shape of `size`.
  QImage imageOf(int camera, const QSize& size);
  QImage fromAbove(const QSize& size);
  bool isHeld(std::size_t targets = 1);

  QString pictures_;
  CameraRig rig_; ///< of what was recorded
};

void ManualPicturesTest::initTestCase() {
  pictures_ = QDir().absoluteFilePath(
      qEnvironmentVariable("DEWPOINT_MANUAL", QStringLiteral("manual-pictures")));
  QVERIFY(QDir().mkpath(pictures_));
  QDir::setCurrent(folder_.path()); // no folder of this machine in the manual
}

void ManualPicturesTest::init() {
  makeWindow({.size = kWindowOfManual, .theme = Theme::Light, .play = false});
}

void ManualPicturesTest::save(const QImage& picture, const QString& name) {
  const QString file = pictures_ + QLatin1Char('/') + name + QStringLiteral(".png");
  QVERIFY2(withFewerLevels(picture).save(file), qPrintable(file));
  QVERIFY2(QFileInfo(file).size() < kLargestPicture, qPrintable(file));
}

void ManualPicturesTest::keep(const QString& name) {
  QVERIFY(settles(*window_));
  save(window_->grab().toImage(), name);
}

void ManualPicturesTest::record(Scene scene, std::int64_t frames) {
  scene.frameCount = frames;
  rig_ = scene.cameras;
  const SceneRenderer renderer(scene);
  for (std::size_t k = 0; k < scene.cameras.size(); ++k) {
    auto writer = FrameWriter::createVideo(path(k == 0 ? "left.mkv" : "right.mkv").string(),
                                           scene.framesPerSecond);
    QVERIFY(writer);
    for (std::int64_t frame = 0; frame < scene.frameCount; ++frame) {
      QVERIFY(writer->write(renderer.render(static_cast<int>(k), frame)));
    }
    QVERIFY(writer->finish());
  }
  QVERIFY(saveCalibration(scene.cameras, path("calibration.toml")));
}

void ManualPicturesTest::openRecordings(bool calibrated) {
  QStringList files{file("left.mkv")};
  if (rig_.size() > 1) {
    files << file("right.mkv");
  }
  if (calibrated) {
    files << file("calibration.toml");
  } else { // or they would be found beside the videos
    std::filesystem::remove(path("calibration.toml"));
    std::filesystem::remove(path("truth.toml"));
  }
  drop(files);
  auto* create = find<QPushButton>("newCreate");
  QVERIFY(waitFor([&] { return create->isEnabled(); }));
  QTest::mouseClick(create, Qt::LeftButton);
  QVERIFY(isOpen(rig_.size()));
}

void ManualPicturesTest::pause() {
  if (shown().state == PlayState::Playing) {
    action("actionPlay")->trigger();
  }
  QVERIFY(waitFor([this] { return shown().state != PlayState::Playing && !shown().rerun; }));
}

void ManualPicturesTest::trackAgain() {
  pause();
  if (action("actionTrackAgain")->isEnabled()) {
    action("actionTrackAgain")->trigger();
    QVERIFY(waitFor([this] { return !action("actionTrackAgain")->isEnabled() && !shown().rerun; }));
  }
}

void ManualPicturesTest::showFrame(qint64 frame) {
  if (shown().history.newestTrackedFrame < frame) {
    if (shown().state != PlayState::Playing) {
      action("actionPlay")->trigger();
    }
    QVERIFY(waitFor([&] { return shown().history.newestTrackedFrame >= frame; }));
  }
  pause();
  window_->selection().requestFrame(frame);
  QVERIFY(waitFor([&] { return shown().frame == frame && !shown().isPreview; }));
}

void ManualPicturesTest::clickAt(int camera, const Eigen::Vector3d& world) {
  const auto* view = find<CameraView>(QStringLiteral("cameraView%1").arg(camera));
  QVERIFY(waitFor([&] { return !view->imageSize().isEmpty() && view->height() > 100; }));
  QVERIFY(keepsItsSize(view));
  const auto at = Projector(rig_.at(static_cast<std::size_t>(camera))).project(world);
  const ImagePlacement& placement = view->placement();
  const QPointF pixel =
      placement.topLeft + (QPointF(at->x(), at->y()) + QPointF(0.5, 0.5)) * placement.scale;
  QTest::mouseClick(find<ImagePickOverlay>(QStringLiteral("cameraView%1Pick").arg(camera)),
                    Qt::LeftButton, Qt::NoModifier, pixel.toPoint());
}

bool ManualPicturesTest::isHeld(std::size_t targets) {
  return waitFor([&] {
    const auto& all = shown().targets;
    return all.size() == targets && std::ranges::all_of(all, [](const TargetSnapshot& target) {
             return std::get<SphereEstimate>(target.estimate).isValid;
           });
  });
}

QImage ManualPicturesTest::imageOf(int camera, const QSize& size) {
  const auto* dock = find<QDockWidget>(QStringLiteral("cameraDock%1").arg(camera));
  const auto* view = find<CameraView>(QStringLiteral("cameraView%1").arg(camera));
  const QImage whole = dock->widget()->grab().toImage();
  const QRect image =
      QRectF(view->placement().topLeft, QSizeF(view->imageSize()) * view->placement().scale)
          .toAlignedRect();
  const QSize part = size.scaled(image.size(), Qt::KeepAspectRatio);
  const QPoint begin = image.center() - QPoint(part.width() / 2, part.height() / 2);
  return whole.copy(QRect(begin, part))
      .scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

QImage ManualPicturesTest::fromAbove(const QSize& size) {
  const QImage whole = grabView(find<QDockWidget>("birdsEyeDock")->widget());
  const QSize part = size.scaled(whole.size(), Qt::KeepAspectRatio) * 0.9;
  return whole.copy((whole.width() - part.width()) / 2, 0, part.width(), part.height())
      .scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

// Scene converge, iteration by iteration: both cameras, and from above.
void ManualPicturesTest::particlesCondense() {
  static constexpr std::array<std::int64_t, 4> kIterations{1, 8, 14, 22};
  static constexpr QSize kCell(300, 225);
  static constexpr int kCaption = 26;
  static constexpr int kGap = 4;
  open("converge");
  auto* above = find<QDockWidget>("birdsEyeDock"); // a window of its own: as large as it is to be
  above->setFloating(true);
  above->resize(2 * kCell.width(), 2 * kCell.height() + 80);
  action("actionLookFromAbove")->trigger();
  action("actionFitScene")->trigger();
  QImage strip(4 * (kCell.width() + kGap) - kGap, kCaption + 3 * (kCell.height() + kGap) - kGap,
               QImage::Format_RGB32);
  strip.fill(Qt::white);
  QPainter painter(&strip);
  for (std::size_t k = 0; k < kIterations.size(); ++k) {
    while (shown().iterationCount < kIterations.at(k)) {
      const std::int64_t next = shown().iterationCount + 1;
      action("actionNextIteration")->trigger();
      QVERIFY(waitFor([&] { return shown().iterationCount >= next; }));
    }
    QVERIFY(settles(*window_));
    QVERIFY(settles(*above));
    const int left = static_cast<int>(k) * (kCell.width() + kGap);
    painter.drawText(QRect(left, 0, kCell.width(), kCaption), Qt::AlignCenter,
                     QStringLiteral("iteration %1").arg(kIterations.at(k)));
    const std::array rows{imageOf(0, kCell), imageOf(1, kCell), fromAbove(kCell)};
    for (std::size_t row = 0; row < rows.size(); ++row) {
      painter.drawImage(left, kCaption + static_cast<int>(row) * (kCell.height() + kGap),
                        rows.at(row));
    }
  }
  painter.end();
  save(strip, QStringLiteral("converge"));
}

void ManualPicturesTest::firstTenMinutes() {
  rig_ = demoRig();
  keep(QStringLiteral("first-start"));
  open();
  showFrame(150);
  keep(QStringLiteral("first-demo"));
  open();
  showFrame(5); // few frames, so that they are tracked again at once
  action("actionLearnColor")->trigger();
  clickAt(0, {0.5, 0.5, 0.15});
  QVERIFY(waitFor([this] { return !shown().masks.empty(); }));
  QVERIFY(jobsEnd());
  showFrame(5);
  keep(QStringLiteral("first-color"));
}

void ManualPicturesTest::twoVideos() {
  record(demoScene(), 150);
  drop({file("left.mkv"), file("right.mkv"), file("calibration.toml")});
  auto* create = find<QPushButton>("newCreate");
  QVERIFY(waitFor([&] { return create->isEnabled(); }));
  QVERIFY(jobsEnd());
  keep(QStringLiteral("tutorial-new-project"));
  QTest::mouseClick(create, Qt::LeftButton);
  QVERIFY(isOpen(2));
  clickAt(0, {0.5, 0.5, 0.15});
  QVERIFY(isHeld());
  showFrame(120);
  keep(QStringLiteral("tutorial-two-videos"));
}

// Cameras where a tape says they are, and the grid on a sheet of paper: the tutorial's numbers.
void ManualPicturesTest::gridByHand() {
  record(demoScene(), 10);
  openRecordings(false);
  window_->resize(kTallWindow);
  action("actionCalibrateByHand")->setChecked(true);
  const auto type = [this](const char* field, double value) {
    find<QDoubleSpinBox>(field)->setValue(value);
  };
  auto* aim = find<QComboBox>("handAimMode");
  aim->setCurrentIndex(1); // yaw, pitch, roll
  Q_EMIT aim->activated(1);
  for (const auto& [camera, numbers] :
       {std::pair(1, std::array{0.07, 0.49, 0.09, 1.3, 7.9}), {0, {0.5, 0.0, 0.2, 90.0, -5.7}}}) {
    window_->selection().selectCamera(camera);
    type("handPositionX", numbers[0]);
    type("handPositionY", numbers[1]);
    type("handPositionZ", numbers[2]);
    type("handAimX", numbers[3]);
    type("handAimY", numbers[4]);
    type("handLens", 350.0);
  }
  type("gridSizeX", 0.148);
  type("gridSizeY", 0.21);
  type("gridOriginX", 0.448);
  type("gridOriginY", 0.582);
  type("gridOriginZ", 0.0);
  type("gridStep", 0.074);
  type("gridTurn", 11.5);
  keep(QStringLiteral("tutorial-grid"));
  action("actionCalibrateByHand")->setChecked(false); // a click now learns a color
  clickAt(0, {0.5, 0.5, 0.15});
  QVERIFY(isHeld());
}

void ManualPicturesTest::board() {
  rig_ = demoRig(); // as many cameras
  QCOMPARE(QProcess::execute(QStringLiteral(DEWPOINT_CLI),
                             {QStringLiteral("simulate"), QStringLiteral("board"),
                              QStringLiteral("--out"), folder_.path()}),
           0);
  openRecordings(false);
  window_->resize(kTallWindow);
  action("actionCalibrateBoard")->trigger();
  find<QCheckBox>("boardFloor")->click();
  find<QPushButton>("boardCalibrate")->click();
  const auto* result = find<QLabel>("boardResult");
  const auto isOver = [&] { return result->text().contains(QStringLiteral("✓")); };
  QVERIFY2(waitFor(isOver) || waitFor(isOver) || waitFor(isOver), qPrintable(result->text()));
  scrollTo(find<QWidget>("boardResult"));
  keep(QStringLiteral("tutorial-board"));
}

void ManualPicturesTest::wand() {
  open();
  action("actionCalibrateWand")->trigger();
  QVERIFY(window_->document().edit(QStringLiteral("nudge"), [](Project& project) {
    project.cameras[1].hasOwnCalibration = true;
    project.cameras[1].camera.cameraFromWorld.translation() += Eigen::Vector3d(0.02, 0.01, 0.0);
  }));
  window_->resize(kTallWindow);
  auto* size = find<QComboBox>("wandSize");
  size->setCurrentIndex(1); // the ball's diameter
  Q_EMIT size->activated(1);
  find<QPushButton>("wandRefine")->click();
  auto* progress = find<QWidget>("wandProgress");
  QVERIFY(waitFor([&] { return !progress->isVisible(); }));
  scrollTo(find<QWidget>("wandReport"));
  keep(QStringLiteral("tutorial-wand"));
}

void ManualPicturesTest::oneCameraAndABox() {
  auto scene = loadScene("one-camera");
  QVERIFY(scene);
  record(*scene, 150);
  openRecordings(false);
  clickAt(0, {0.5, 0.5, 0.15});
  QVERIFY(waitFor([this] { return shown().targets.size() == 1; }));
  showFrame(100);
  find<QDockWidget>("targetDock")->raise();
  keep(QStringLiteral("tutorial-box"));
}

void ManualPicturesTest::peopleInARoom() {
  open("office");
  showFrame(118);
  keep(QStringLiteral("tutorial-people"));
}

void ManualPicturesTest::severalTargets() {
  auto scene = loadScene(DEWPOINT_SOURCE_DIR "/docs/examples/scenes/two-balls.toml");
  QVERIFY(scene);
  record(*scene, 120);
  openRecordings(true);
  clickAt(0, {0.42, 0.56, 0.15});
  QVERIFY(isHeld(1));
  action("actionAddTarget")->trigger();
  clickAt(0, {0.58, 0.42, 0.17});
  QVERIFY(isHeld(2));
  trackAgain();
  showFrame(80);
  action("actionShowMask")->setChecked(false);
  find<QDockWidget>("targetDock")->raise();
  keep(QStringLiteral("tutorial-several"));
}

void ManualPicturesTest::changingLight() {
  auto scene = loadScene(DEWPOINT_SOURCE_DIR "/docs/examples/scenes/evening.toml");
  QVERIFY(scene);
  record(*scene, 300);
  openRecordings(true);
  clickAt(0, {0.5, 0.5, 0.15});
  QVERIFY(isHeld());
  QVERIFY(window_->document().edit(QStringLiteral("adapt"), [](Project& project) {
    (void)project.parameters.set("color_adaptation", 2.0);
  }));
  trackAgain();
  showFrame(210);
  action("actionShowMask")->setChecked(true);
  keep(QStringLiteral("tutorial-light"));
}

DEWPOINT_WINDOW_TEST(ManualPicturesTest)

} // namespace dewpoint::tests

#include "manual_pictures_test.moc"
