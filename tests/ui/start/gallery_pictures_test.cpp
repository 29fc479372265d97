// SPDX-License-Identifier: GPL-3.0-or-later
// The pictures of the start page's gallery, made of the built-in scenes: into the folder that
// DEWPOINT_GALLERY names (resources/gallery), or beside the test.
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/cameraview/camera_view.h"
#include "ui/export/view_picture.h"
#include "ui/selection/selection.h"

#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QPainter>

#include <algorithm>

namespace dewpoint::tests {

namespace {

constexpr QSize kPicture(480, 270);
constexpr int kQuality = 82;
constexpr qint64 kLargestFile = 40 << 10; ///< bytes

} // namespace

class GalleryPicturesTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void initTestCase();
  void init() { makeWindow({.size = {1400, 900}, .theme = Theme::Dark}); }
  void cleanup() { window_.reset(); }
  void scenes_data();
  void scenes();

private:
  /// Opens a scene and shows one of its frames, paused.
  void showFrame(const QString& scene, qint64 frame);
  /// The view in a window of its own, so that it is as large as it is to be.
  QImage pictureIn(const QString& dock, const QSize& size);
  QImage cameraPicture(int camera);
  static QImage cropped(const QImage& picture, const QSize& size, const QPointF& middle,
                        double share = 1.0);

  QString folder_;
};

void GalleryPicturesTest::initTestCase() {
  folder_ = qEnvironmentVariable("DEWPOINT_GALLERY", QStringLiteral("gallery"));
  QVERIFY(QDir().mkpath(folder_));
}

void GalleryPicturesTest::showFrame(const QString& scene, qint64 frame) {
  open(scene.toStdString());
  action("actionShowMagnifier")->setChecked(false); // it would be cut
  QVERIFY(waitFor([&] { return shown().frame >= frame; }));
  if (shown().state == PlayState::Playing) {
    action("actionPlay")->trigger();
  }
  QVERIFY(waitFor([this] { return shown().state != PlayState::Playing; }));
  window_->selection().requestFrame(frame);
  QVERIFY(waitFor([&] { return shown().frame == frame; }));
}

QImage GalleryPicturesTest::pictureIn(const QString& dock, const QSize& size) {
  auto* found = find<QDockWidget>(dock);
  found->setFloating(true);
  found->resize(size);
  found->raise();
  return settles(*found) ? grabView(found->widget()) : QImage();
}

/// The image of a camera with all that is drawn over it, without what is beside it.
QImage GalleryPicturesTest::cameraPicture(int camera) {
  const QImage whole = pictureIn(QStringLiteral("cameraDock%1").arg(camera), {640, 720});
  const auto* view = find<CameraView>(QStringLiteral("cameraView%1").arg(camera));
  const QSizeF size = QSizeF(view->imageSize()) * view->placement().scale;
  return whole.copy(QRectF(view->placement().topLeft, size).toAlignedRect());
}

/// The largest part of a picture that has the shape of `size`, or a share of it, with its middle as
/// near to `middle` (0 to 1 across and down) as there is room.
QImage GalleryPicturesTest::cropped(const QImage& picture, const QSize& size, const QPointF& middle,
                                    double share) {
  const QSize part = size.scaled(picture.size(), Qt::KeepAspectRatio) * share;
  const auto begin = [](double at, int whole, int length) {
    return std::clamp(qRound(at * whole - 0.5 * length), 0, whole - length);
  };
  return picture
      .copy(begin(middle.x(), picture.width(), part.width()),
            begin(middle.y(), picture.height(), part.height()), part.width(), part.height())
      .scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

void GalleryPicturesTest::scenes_data() {
  QTest::addColumn<QString>("scene");
  QTest::addColumn<qint64>("frame");
  QTest::addColumn<int>("camera");
  QTest::addColumn<QPointF>("middle"); // of the part of its image
  QTest::addColumn<bool>("inSpace");   // the bird's-eye view beside it
  QTest::newRow("demo") << QString() << qint64{150} << 1 << QPointF(0.5, 0.5) << true;
  QTest::newRow("converge") << "converge" << qint64{11} << 0 << QPointF(0.5, 0.5) << true;
  QTest::newRow("occluder") << "occluder" << qint64{50} << 0 << QPointF(0.5, 0.5) << false;
  QTest::newRow("look-alikes") << "look-alikes" << qint64{20} << 0 << QPointF(0.5, 0.75) << false;
  QTest::newRow("office") << "office" << qint64{118} << 0 << QPointF(0.5, 0.5) << true;
  QTest::newRow("one-camera") << "one-camera" << qint64{45} << 0 << QPointF(0.5, 0.5) << false;
  QTest::newRow("calibrate") << QString() << qint64{30} << 0 << QPointF(0.5, 0.7) << false;
}

void GalleryPicturesTest::scenes() {
  QFETCH(QString, scene);
  QFETCH(qint64, frame);
  QFETCH(int, camera);
  QFETCH(QPointF, middle);
  QFETCH(bool, inSpace);
  const QString name = QLatin1String(QTest::currentDataTag());
  showFrame(scene, frame);
  if (name == QLatin1String("calibrate")) {
    action("actionCalibrateByHand")->setChecked(true);
  }
  const QImage image = cameraPicture(camera);
  QVERIFY(!image.isNull());
  QImage picture = cropped(image, kPicture, middle);
  if (inSpace) {
    const QSize half(kPicture.width() / 2, kPicture.height());
    action("actionLookFree")->trigger();
    const QImage space = pictureIn(QStringLiteral("birdsEyeDock"), {720, 830});
    QVERIFY(!space.isNull());
    QPainter painter(&picture);
    painter.drawImage(0, 0, cropped(image, half, middle));
    painter.drawImage(half.width(), 0, cropped(space, half, {0.5, 0.45}, 0.92)); // with the names
  }
  const QString file = QStringLiteral("%1/%2.jpg").arg(folder_, name);
  QVERIFY2(picture.save(file, "JPG", kQuality), qPrintable(file));
  QVERIFY2(QFileInfo(file).size() < kLargestFile, qPrintable(file));
}

DEWPOINT_WINDOW_TEST(GalleryPicturesTest)

} // namespace dewpoint::tests

#include "gallery_pictures_test.moc"
