// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/planning/rig_map.h"
#include "tests/ui/scene3d/ball_snapshot.h"
#include "tests/ui/scene3d/scene_test.h"
#include "ui/view3d/birds_eye_view.h"

#include <QApplication>
#include <QFile>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include <cmath>
#include <limits>

namespace dewpoint::tests {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// By hand: a parallel picture is its middle plus meters over meters per pixel; rows grow
/// downwards.
QPointF flatProjection(const Scene3d& scene, const QImage& picture, double right, double up,
                       double focusRight, double focusUp) {
  return {picture.width() / 2.0 + (right - focusRight) / scene.metersPerPixel(),
          picture.height() / 2.0 - (up - focusUp) / scene.metersPerPixel()};
}

void keep(const QImage& picture, const char* name) {
  const QString folder = qEnvironmentVariable("DEWPOINT_PICTURES");
  if (!folder.isEmpty()) {
    QVERIFY(picture.save(folder + QLatin1Char('/') + QLatin1String(name) + QLatin1String(".png")));
  }
}

int differentPixels(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < std::min(a.height(), b.height()); ++y) {
    for (int x = 0; x < std::min(a.width(), b.width()); ++x) {
      count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
    }
  }
  return count;
}

} // namespace

class BirdsEyeViewTest : public QObject {
  Q_OBJECT

private Q_SLOTS:
  void init() {
    view_ = std::make_unique<BirdsEyeView>();
    view_->resize(640, 480);
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
    view_->lookFromAbove();
  }
  void cleanup() { view_.reset(); }

  void emptyRoomShowsTheGrid() {
    const QImage picture = view_->currentImage();
    QVERIFY(view_->hasImage());
    QCOMPARE(picture.size(), (QSizeF(view_->size()) * view_->devicePixelRatioF()).toSize());
    QCOMPARE(blob(picture, {320, 240}, 2000.0).count, 0);
    QVERIFY(picture.pixel(2, 2) !=
            picture.pixel(picture.width() / 2 + 5, picture.height() / 2 + 5));
    keep(picture, "empty");
  }

  void fromAboveTheBallIsWhereXAndYSay() {
    view_->setRaysShown(false); // they are of its color
    view_->setSnapshot(ballSnapshot());
    const QImage picture = view_->currentImage();
    keep(picture, "above");
    const Scene3d& scene = view_->scene();
    const QPointF expected = flatProjection(scene, picture, kBall.x(), kBall.y(),
                                            scene.focalPoint().x(), scene.focalPoint().y());
    // Near enough that neither tail nor far particles count: the sphere alone, symmetric. The
    // truth's cross, 0.02 m aside, hides a few pixels.
    const Blob found = blob(picture, expected, 0.03 / scene.metersPerPixel());
    QVERIFY(found.count > 20);
    QVERIFY(std::abs(found.center.x() - expected.x()) < 2.5 * view_->devicePixelRatioF());
    QVERIFY(std::abs(found.center.y() - expected.y()) < 2.5 * view_->devicePixelRatioF());
    // The cloud reaches two sigma (0.16 m), far less than the mirrored place.
    const QPointF mirrored = flatProjection(scene, picture, kBall.x(), -kBall.y() + 0.4,
                                            scene.focalPoint().x(), scene.focalPoint().y());
    QVERIFY(blob(picture, expected, 0.16 / scene.metersPerPixel()).count > 3 * found.count / 2);
    QCOMPARE(blob(picture, mirrored, 0.05 / scene.metersPerPixel()).count, 0);
  }

  void fromTheFrontTheBallIsWhereXAndZSay() {
    const QSignalSpy changed(view_.get(), &BirdsEyeView::viewChanged);
    view_->setSnapshot(ballSnapshot());
    const QImage above = view_->currentImage();
    view_->lookFromFront();
    const QImage front = view_->currentImage();
    keep(front, "front");
    QCOMPARE(changed.count(), 1);
    QCOMPARE(view_->currentView(), Scene3d::View::Front);
    const Scene3d& scene = view_->scene();
    const QPointF expected = flatProjection(scene, front, kBall.x(), kBall.z(),
                                            scene.focalPoint().x(), scene.focalPoint().z());
    const Blob found = blob(front, expected, 0.03 / scene.metersPerPixel());
    QVERIFY(found.count > 20);
    QVERIFY(std::abs(found.center.x() - expected.x()) < 2.5 * view_->devicePixelRatioF());
    QVERIFY(std::abs(found.center.y() - expected.y()) < 2.5 * view_->devicePixelRatioF());
    QVERIFY(differentPixels(above, front) > above.width() * above.height() / 20);
  }

  void fromTheSideTheBallIsWhereYAndZSay() {
    view_->setSnapshot(ballSnapshot());
    view_->lookFromSide();
    const QImage side = view_->currentImage();
    keep(side, "side");
    QCOMPARE(view_->currentView(), Scene3d::View::Side);
    const Scene3d& scene = view_->scene();
    QVERIFY((scene.rightAxisInWorld() - Eigen::Vector3d::UnitY()).norm() < 1e-9);
    QVERIFY((scene.upAxisInWorld() - Eigen::Vector3d::UnitZ()).norm() < 1e-9);
    const QPointF expected = flatProjection(scene, side, kBall.y(), kBall.z(),
                                            scene.focalPoint().y(), scene.focalPoint().z());
    const Blob found = blob(side, expected, 0.03 / scene.metersPerPixel());
    QVERIFY(found.count > 20);
    QVERIFY(std::abs(found.center.x() - expected.x()) < 2.5 * view_->devicePixelRatioF());
    QVERIFY(std::abs(found.center.y() - expected.y()) < 2.5 * view_->devicePixelRatioF());
    // From the side, the floor has no places to click.
    view_->setPersonPlacingMode(true);
    QCOMPARE(view_->currentView(), Scene3d::View::Above);
  }

  void darkAndFreeDiffer() {
    view_->setSnapshot(ballSnapshot());
    view_->lookInPerspective();
    const QImage light = view_->currentImage();
    keep(light, "free");
    QPalette dark;
    dark.setColor(QPalette::Window, QColor(30, 32, 36));
    dark.setColor(QPalette::WindowText, Qt::white);
    dark.setColor(QPalette::ButtonText, Qt::white);
    view_->setPalette(dark);
    const QImage picture = view_->currentImage();
    keep(picture, "free_dark");
    QVERIFY(qGray(light.pixel(2, 2)) > 200);
    QVERIFY(qGray(picture.pixel(2, 2)) < 60);
    view_->lookFromAbove();
    keep(view_->currentImage(), "above_dark");
    keep(view_->grab().toImage(), "widget_dark");
  }

  void newSnapshotsMoveTheBall() {
    view_->setSnapshot(ballSnapshot());
    const QImage before = view_->currentImage();
    QCOMPARE(differentPixels(before, view_->currentImage()), 0);
    auto next = ballSnapshot({-0.6, 0.5, 0.7});
    view_->setSnapshot(next);
    const QImage picture = view_->currentImage();
    const Scene3d& scene = view_->scene();
    const QPointF expected =
        flatProjection(scene, picture, -0.6, 0.5, scene.focalPoint().x(), scene.focalPoint().y());
    QVERIFY(blob(picture, expected, 0.03 / scene.metersPerPixel()).count > 20);
    view_->setSnapshot(TrackSnapshotPtr{});
    QCOMPARE(blob(view_->currentImage(), expected, 0.2 / scene.metersPerPixel()).count, 0);
  }

  void aTailHasGapsWhereTheTargetWasNotHeld() {
    auto whole = ballSnapshot();
    auto torn = ballSnapshot();
    // Away from ball and cloud, and not yet faded: the cloud's sigma is 0.08 m, a place of the tail
    // every 0.03 m, the last of 40 at the ball.
    for (std::size_t i = 23; i < 31; ++i) {
      torn->targets[0].tailPositions[i].setConstant(kNaN);
    }
    view_->setSnapshot(whole);
    const QImage before = view_->currentImage();
    const Scene3d& scene = view_->scene();
    const auto at = [&](std::size_t i) {
      const Eigen::Vector2d place = scene.projectToImage(whole->targets[0].tailPositions[i]);
      return QPointF(before.width() / 2.0 + place.x(), before.height() / 2.0 - place.y());
    };
    const QPointF inGap = at(27);
    const QPointF held = at(20);
    QVERIFY(blob(before, inGap, 4.0).count > 0 && blob(before, held, 4.0).count > 0);
    view_->setSnapshot(torn);
    const QImage after = view_->currentImage();
    QCOMPARE(blob(after, inGap, 4.0).count, 0);
    QVERIFY(blob(after, held, 4.0).count > 0);
  }

  void theBestParticleIsMarkedOnlyWhenItIsWanted() {
    const auto snapshot = ballSnapshot();
    std::get<SphereEstimate>(snapshot->targets[0].estimate).best =
        kBall + Eigen::Vector3d(0.3, 0.2, 0.0); // beside the cloud
    view_->setSnapshot(snapshot);
    const QImage without = view_->currentImage();
    view_->setBestParticleShown(true);
    QVERIFY(differentPixels(without, view_->currentImage()) > 10); // a triangle of 14 x 12 px
    view_->setBestParticleShown(false);
    QCOMPARE(differentPixels(without, view_->currentImage()), 0);
  }

  void numbersAreWrittenAsTheLanguageDoes() {
    view_->setLocale(QLocale(QLocale::English));
    const QImage english = view_->currentImage();
    view_->setLocale(QLocale(QLocale::German));
    QVERIFY(view_->currentImage() != english);
    view_->setLocale(QLocale(QLocale::English));
    QCOMPARE(view_->currentImage(), english);
  }

  void numbersThatAreNotFiniteAreLeftOut() {
    auto snapshot = ballSnapshot();
    TargetSnapshot& target = snapshot->targets[0];
    target.particles.row(3).setConstant(kNaN);
    target.weights[5] = kNaN;
    target.tailPositions[2].x() = kNaN;
    TargetSnapshot lost = target;
    std::get<SphereEstimate>(lost.estimate).mean.setConstant(kNaN);
    std::get<SphereEstimate>(lost.estimate).covariance.setConstant(kNaN);
    lost.truth = Eigen::Vector3d(kNaN, 0.0, 0.0);
    lost.particles.setConstant(kNaN);
    lost.weights.resize(0);
    snapshot->targets.push_back(lost);
    Camera broken = snapshot->rig->front();
    broken.cameraFromWorld.translation().setConstant(kNaN);
    CameraRig rig = *snapshot->rig;
    rig.push_back(broken);
    snapshot->rig = std::make_shared<CameraRig>(rig);
    view_->setSnapshot(snapshot);
    const QImage picture = view_->currentImage();
    const Scene3d& scene = view_->scene();
    QVERIFY(std::isfinite(scene.metersPerPixel()) && scene.focalPoint().allFinite());
    const QPointF expected = flatProjection(scene, picture, kBall.x(), kBall.y(),
                                            scene.focalPoint().x(), scene.focalPoint().y());
    QVERIFY(blob(picture, expected, 0.045 / scene.metersPerPixel()).count > 20); // with the rim
  }

  void aRigThatWasCalibratedAgainIsSeenAsIfItWereNew_data() {
    QTest::addColumn<bool>("firstCameraStays");
    QTest::newRow("all cameras move") << false;
    QTest::newRow("the first camera stays") << true; // a board calibration without a floor
  }
  void aRigThatWasCalibratedAgainIsSeenAsIfItWereNew() {
    // The same cameras in a room of a tenth of the size: what calibration makes of a guess.
    QFETCH(bool, firstCameraStays);
    const auto guessed = ballSnapshot();
    guessed->targets.clear();
    const auto small = std::make_shared<TrackSnapshot>(*guessed);
    CameraRig rig = *guessed->rig;
    const Eigen::Vector3d fixed =
        firstCameraStays ? rig.front().center() : Eigen::Vector3d(Eigen::Vector3d::Zero());
    for (std::size_t k = firstCameraStays ? 1 : 0; k < rig.size(); ++k) {
      const Eigen::Vector3d center = fixed + 0.1 * (rig[k].center() - fixed);
      rig[k].cameraFromWorld.translation() = -(rig[k].cameraFromWorld.linear() * center);
    }
    small->rig = std::make_shared<CameraRig>(rig);
    view_->setSnapshot(small);
    view_->currentImage();
    const double expected = view_->scene().metersPerPixel();

    init();
    view_->setSnapshot(guessed);
    view_->currentImage();
    QVERIFY(view_->scene().metersPerPixel() > 5.0 * expected);
    view_->setSnapshot(small);
    view_->currentImage();
    QCOMPARE(view_->scene().metersPerPixel(), expected);
  }

  void oneCameraThatIsMovedLeavesThePictureStill() {
    const auto snapshot = ballSnapshot();
    view_->setSnapshot(snapshot);
    view_->currentImage();
    const double before = view_->scene().metersPerPixel();
    const auto moved = std::make_shared<TrackSnapshot>(*snapshot);
    CameraRig rig = *snapshot->rig;
    rig.front().cameraFromWorld.translation() *= 0.9; // nearer to the others
    moved->rig = std::make_shared<CameraRig>(rig);
    view_->setSnapshot(moved);
    view_->currentImage();
    QCOMPARE(view_->scene().metersPerPixel(), before);
  }

  void draggingMovesAndDoubleClickRestores() {
    view_->setSnapshot(ballSnapshot());
    const QImage before = view_->currentImage();
    const Eigen::Vector3d focus = view_->scene().focalPoint();
    QTest::mousePress(view_.get(), Qt::LeftButton, {}, {300, 200});
    QTest::mouseMove(view_.get(), {360, 220});
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, {360, 220});
    view_->currentImage();
    // 60 px to the right drag the room along: the focus goes left by as many meters.
    const double meters = view_->scene().metersPerPixel() * view_->devicePixelRatioF();
    QVERIFY(std::abs(view_->scene().focalPoint().x() - (focus.x() - 60.0 * meters)) < 2.0 * meters);
    QVERIFY(std::abs(view_->scene().focalPoint().y() - (focus.y() + 20.0 * meters)) < 2.0 * meters);
    QTest::mouseDClick(view_.get(), Qt::LeftButton, {}, {300, 200});
    QCOMPARE(differentPixels(before, view_->currentImage()), 0);
  }

  void orbitingTurnsTheFreeView() {
    view_->setSnapshot(ballSnapshot());
    view_->lookInPerspective();
    const QImage before = view_->currentImage();
    QTest::mousePress(view_.get(), Qt::LeftButton, {}, {300, 200});
    QTest::mouseMove(view_.get(), {380, 230});
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, {380, 230});
    const QImage after = view_->currentImage();
    keep(after, "orbited");
    QVERIFY(differentPixels(before, after) > before.width() * before.height() / 50);
  }

  void buttonsChooseTheView() {
    auto* front = view_->findChild<QToolButton*>(QStringLiteral("lookFromFrontButton"));
    QVERIFY(front != nullptr);
    QTest::mouseClick(front, Qt::LeftButton);
    QCOMPARE(view_->currentView(), Scene3d::View::Front);
    QVERIFY(front->isChecked());
    auto* side = view_->findChild<QToolButton*>(QStringLiteral("lookFromSideButton"));
    QTest::mouseClick(side, Qt::LeftButton);
    QCOMPARE(view_->currentView(), Scene3d::View::Side);
    QVERIFY(side->isChecked() && !front->isChecked());
    QVERIFY(!view_->accessibleName().isEmpty());
  }

  void picturesComeOnTheirOwn() {
    view_->setSnapshot(ballSnapshot());
    const double ratio = view_->devicePixelRatioF();
    // Nothing but the target has its color; the timer alone brings the picture.
    QTRY_VERIFY_WITH_TIMEOUT(
        blob(view_->grab().toImage(), {320 * ratio, 240 * ratio}, 400 * ratio).count > 100, 5000);
    keep(view_->grab().toImage(), "widget");
  }

  /// Run by itself without a display too (see CMakeLists.txt).
  void aMapIsBlueWhereItIsGood() {
    // West: a tenth of what is good enough; east: ten times; north of y = 1: seen by one camera.
    auto map = std::make_shared<RigMap>();
    map->grid = {{-2, -2, 0}, {2, 2, 2}, {4, 4, 2}};
    for (std::size_t i = 0; i < map->grid.cellCount(); ++i) {
      const bool north = i / 4 % 4 == 3;
      map->sigmas.push_back(north ? float(kNaN) : i % 4 < 2 ? 0.0005F : 0.05F);
      map->cameraCounts.push_back(north ? 1 : 3);
    }
    view_->setSnapshot(ballSnapshot());
    MapOptions look;
    view_->showMap(map, look);
    const QImage picture = view_->currentImage();
    keep(picture, "map");
    const Scene3d& scene = view_->scene();
    const auto colorAt = [&](double x, double y) {
      const QPointF at =
          flatProjection(scene, picture, x, y, scene.focalPoint().x(), scene.focalPoint().y());
      return picture.pixel(at.toPoint());
    };
    QVERIFY(qBlue(colorAt(-1.45, -1.45)) > qRed(colorAt(-1.45, -1.45)) + 40);
    QVERIFY(qRed(colorAt(1.45, -1.45)) > qBlue(colorAt(1.45, -1.45)) + 40);
    const QRgb blank = colorAt(-1.45, 1.45);
    QVERIFY(std::abs(qBlue(blank) - qRed(blank)) < 30);
    const auto west = scene.positionInMapLayer(scene.projectToImage({-1.45, -1.45, 0.0}));
    QVERIFY(west.has_value());
    QCOMPARE(cellAt(map->grid, *west), std::optional<std::size_t>(0));
    look.showsVolume = true;
    view_->showMap(map, look);
    QVERIFY(differentPixels(view_->currentImage(), picture) > 1000);
    view_->showMap(nullptr, look);
    (void)view_->currentImage();
    QVERIFY(!scene.positionInMapLayer({0.0, 0.0}));
  }

  void withoutOpenGlTheWidgetStillWorks() {
    view_->setSnapshot(ballSnapshot());
    view_->lookInPerspective();
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, {100, 100});
    QTest::keyClick(view_.get(), Qt::Key_Plus);
    const QImage shown = view_->grab().toImage();
    QCOMPARE(view_->hasImage(), !view_->currentImage().isNull());
    QCOMPARE(view_->hasImage(), qEnvironmentVariableIsSet("DISPLAY"));
    keep(shown, view_->hasImage() ? "zoomed" : "no_3d");
    // Something is written or drawn either way.
    QVERIFY(differentPixels(shown, shown.mirrored()) > 50);
  }

  void noQt5InTheProcess() {
    view_->currentImage();
    QFile maps(QStringLiteral("/proc/self/maps"));
    QVERIFY(maps.open(QIODevice::ReadOnly));
    const QByteArray mapped = maps.readAll();
    QVERIFY(mapped.contains("libQt6Widgets"));
    QVERIFY(!mapped.contains("libQt5"));
  }

private:
  std::unique_ptr<BirdsEyeView> view_;
};

DEWPOINT_NAMED_TEST(BirdsEyeViewTest, &runSceneTest<BirdsEyeViewTest>)

} // namespace dewpoint::tests

#include "birds_eye_view_test.moc"
