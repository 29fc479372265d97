// SPDX-License-Identifier: GPL-3.0-or-later
// Planning a rig in the real window: the map of expected errors, and cameras that are thought of.
#include "tests/ui/calibration/calibration_window.h"
#include "tests/ui/event_loop_probe.h"
#include "tests/ui/window_test.h"
#include "ui/calibration/calibration_dock.h"
#include "ui/calibration/planner/rig_planner.h"
#include "ui/view3d/birds_eye_view.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>

namespace dewpoint::tests {

class PlannerPageTest : public QObject, private test::CalibrationWindow {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup();
  void opensByItsAction();
  void theMapHasASentenceAndALegend();
  void theMapFollowsEveryMove();
  void layerAndVolumeAreSet();
  void aPlannedCameraIsNoPartOfTheProject();
  void aPlannedCameraIsDragged();
  void theBestPlaceIsFoundAndShown();
  void aSearchCanBeCanceled();
  void draggingStaysFluid();

private:
  RigPlanner& plan() { return *window_->findChild<RigPlanner*>(); }
  BirdsEyeView& view() { return *find<BirdsEyeView>("birdsEyeView"); }
  bool waitForMap(const std::function<void()>& act);
  void showMap();
  QPointF placeInView(const Eigen::Vector3d& point);
  /// `between` is called after each step; without it the window only does what waits to be done.
  void dragInView(
      const QPointF& from, const QPointF& by, int steps,
      const std::function<void()>& between = [] { QCoreApplication::processEvents(); });
};

void PlannerPageTest::init() {
  openCalibration();
  find<QAction>("actionPlanRig")->trigger();
}

void PlannerPageTest::cleanup() {
  window_.reset();
}

/// Whether another map comes of it.
bool PlannerPageTest::waitForMap(const std::function<void()>& act) {
  const auto before = plan().map();
  act();
  return waitFor([&] { return plan().map() != nullptr && plan().map() != before; });
}

void PlannerPageTest::showMap() {
  QVERIFY(waitForMap([this] { find<QAction>("actionShowMap")->trigger(); }));
}

QPointF PlannerPageTest::placeInView(const Eigen::Vector3d& point) {
  const Eigen::Vector2d at = view().scene().projectToImage(point) / view().devicePixelRatioF();
  return {view().width() / 2.0 + at.x(), view().height() / 2.0 - at.y()};
}

void PlannerPageTest::dragInView(const QPointF& from, const QPointF& by, int steps,
                                 const std::function<void()>& between) {
  const auto send = [&](QEvent::Type type, const QPointF& at) {
    QMouseEvent event(
        type, at, view().mapToGlobal(at), type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton,
        type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&view(), &event);
  };
  send(QEvent::MouseButtonPress, from);
  for (int k = 1; k <= steps; ++k) {
    send(QEvent::MouseMove, from + by * k / steps);
    between();
  }
  send(QEvent::MouseButtonRelease, from + by);
}

void PlannerPageTest::opensByItsAction() {
  QCOMPARE(find<CalibrationDock>("calibrationPlace")->shownPage(), QStringLiteral("planPage"));
  QVERIFY(find<QWidget>("planPage")->isVisible());
  QVERIFY(!find<QCheckBox>("mapShown")->isChecked());
  QVERIFY(view().map() == nullptr);
  QCOMPARE(history().count(), 0);
}

void PlannerPageTest::theMapHasASentenceAndALegend() {
  const QImage before = view().currentImage();
  showMap();
  QVERIFY(find<QCheckBox>("mapShown")->isChecked());
  QVERIFY(view().map() == plan().map().get());
  QVERIFY(view().currentImage() != before);
  auto* summary = find<QLabel>("mapSummary");
  QVERIFY(summary->isVisible());
  QVERIFY2(summary->text().contains(QLatin1String("at most 5 mm")), qPrintable(summary->text()));
  // A stricter limit: less of the volume is within it.
  const auto within = [&] {
    return summaryOf(*plan().map(), plan().mapOptions().maxGoodSigma).fractionWithinLimit;
  };
  const double share = within();
  find<QDoubleSpinBox>("mapGood")->setValue(0.5);
  QVERIFY(within() < share);
  QVERIFY(summary->text().contains(QLatin1String("0.5 mm")));
  // Twice the error of a sighting is twice the error everywhere.
  const double median = summaryOf(*plan().map(), 1.0).medianSigma;
  QVERIFY(waitForMap([&] { find<QDoubleSpinBox>("mapPixelSigma")->setValue(1.0); }));
  QVERIFY(std::abs(summaryOf(*plan().map(), 1.0).medianSigma / median - 2.0) < 1e-3);
  // It goes with the calibration place, and comes back with it.
  QTest::keyClick(window_.get(), Qt::Key_C); // the page that C is for
  QVERIFY(view().map() != nullptr);
  QTest::keyClick(window_.get(), Qt::Key_C);
  QVERIFY(view().map() == nullptr);
  QTest::keyClick(window_.get(), Qt::Key_C);
  QVERIFY(view().map() != nullptr);
  find<QCheckBox>("mapShown")->click();
  QVERIFY(view().map() == nullptr);
  QVERIFY(!find<QAction>("actionShowMap")->isChecked());
}

void PlannerPageTest::theMapFollowsEveryMove() {
  showMap();
  // A nudge of the page "By hand".
  layer(0)->setFocus();
  QVERIFY(waitForMap([this] { QTest::keyClick(layer(0), Qt::Key_D, Qt::ShiftModifier); }));
  // Taking it back.
  QVERIFY(waitForMap([this] { history().undo(); }));
  // Dragged in the bird's-eye view.
  const QPointF at = placeInView(camera(0).center());
  QVERIFY(waitForMap([&] { dragInView(at, {25.0, 10.0}, 4); }));
  QCOMPARE(history().count(), 1);
}

void PlannerPageTest::layerAndVolumeAreSet() {
  showMap();
  find<QDoubleSpinBox>("mapHeight")->setValue(0.1);
  QCOMPARE(view().mapOptions().layerHeight, 0.1);
  find<QSlider>("mapHeightSlider")->setValue(0);
  QCOMPARE(view().mapOptions().layerHeight, plan().volume().min().z());
  find<QDoubleSpinBox>("mapHeight")->setValue(900.0); // kept within the volume
  QCOMPARE(view().mapOptions().layerHeight, plan().volume().max().z());
  auto* volume = find<QCheckBox>("mapVolume");
  const bool was = view().mapOptions().showsVolume;
  volume->click();
  QCOMPARE(view().mapOptions().showsVolume, !was);
  Q_EMIT find<QComboBox>("mapQuantity")->activated(1);
  QVERIFY(view().mapOptions().quantity == MapQuantity::CameraCount);
  const Eigen::AlignedBox3d room = plan().volume();
  QVERIFY(plan().followsProjectVolume());
  QVERIFY(waitForMap([&] { find<QDoubleSpinBox>("mapLowX")->setValue(room.min().x() - 1.0); }));
  QVERIFY(std::abs(plan().map()->grid.low.x() - (room.min().x() - 1.0)) < 0.0006);
  // A volume turned inside out is refused, and the field shows what there is.
  auto* high = find<QDoubleSpinBox>("mapHighX");
  const double kept = high->value();
  high->setValue(-999.0);
  QCOMPARE(high->value(), kept);
  find<QPushButton>("mapRoom")->click();
  QVERIFY(plan().followsProjectVolume());
  QVERIFY(plan().volume().isApprox(room));
  QCOMPARE(history().count(), 0);
}

void PlannerPageTest::aPlannedCameraIsNoPartOfTheProject() {
  showMap();
  const Project before = project();
  QVERIFY(waitForMap([this] { find<QPushButton>("planAdd")->click(); }));
  QCOMPARE(plan().map()->cameraCount, before.cameras.size() + 1);
  QCOMPARE(plan().plannedCameras().size(), 1U);
  QCOMPARE(find<QComboBox>("planCamera")->count(), 1);
  // Numbers: where it stands, what it looks at, its lens.
  QVERIFY(waitForMap([this] { find<QDoubleSpinBox>("planPlaceX")->setValue(1.25); }));
  QVERIFY(std::abs(plan().plannedCameras()[0].center().x() - 1.25) < 1e-9);
  QVERIFY(waitForMap([this] { find<QDoubleSpinBox>("planTargetY")->setValue(0.75); }));
  const Eigen::Vector3d target = aimPoint(plan().plannedCameras()[0], plan().volume().min().z());
  QVERIFY(std::abs(target.y() - 0.75) < 1e-6);
  QVERIFY(waitForMap([this] { find<QDoubleSpinBox>("planFieldOfView")->setValue(90.0); }));
  const Intrinsics& lens = plan().plannedCameras()[0].intrinsics;
  QVERIFY(std::abs(lens.focalX - lens.width / 2.0) < 1e-6); // the tangent of 45 degrees is 1
  QVERIFY(project() == before);
  QCOMPARE(history().count(), 0);
  QVERIFY(waitForMap([this] { find<QPushButton>("planRemove")->click(); }));
  QCOMPARE(plan().map()->cameraCount, before.cameras.size());
  QVERIFY(!find<QPushButton>("planRemove")->isEnabled());
}

void PlannerPageTest::aPlannedCameraIsDragged() {
  view().lookFromAbove(); // there, pixels are meters along x and y
  showMap();
  find<QAction>("actionPlanCamera")->trigger();
  (void)view().currentImage(); // the view is framed anew
  const Camera before = plan().plannedCameras()[0];
  const QPointF from = placeInView(before.center());
  const double scale = view().scene().metersPerPixel() * view().devicePixelRatioF();
  QVERIFY(waitForMap([&] { dragInView(from, {-20.0, 12.0}, 4); }));
  const Eigen::Vector3d moved = plan().plannedCameras()[0].center() - before.center();
  QVERIFY(std::abs(moved.x() + 20.0 * scale) < 1.5 * scale);
  QVERIFY(std::abs(moved.y() + 12.0 * scale) < 1.5 * scale);
  QCOMPARE(plan().selectedCamera(), 0);
  QCOMPARE(history().count(), 0);
  // One of the project is taken: the planned one is not chosen any more.
  dragInView(placeInView(camera(0).center()), {4.0, 0.0}, 1);
  QCOMPARE(plan().selectedCamera(), -1);
}

void PlannerPageTest::theBestPlaceIsFoundAndShown() {
  showMap();
  const double before =
      summaryOf(*plan().map(), plan().mapOptions().maxGoodSigma).fractionWithinLimit;
  find<QPushButton>("planFind")->click();
  QVERIFY(waitFor([&] { return !plan().plannedCameras().empty(); }));
  QVERIFY(waitFor([&] { return plan().map()->cameraCount == project().cameras.size() + 1; }));
  QVERIFY(summaryOf(*plan().map(), plan().mapOptions().maxGoodSigma).fractionWithinLimit >= before);
  const Eigen::Vector3d place = plan().plannedCameras()[0].center();
  const Eigen::AlignedBox3d& box = plan().volume();
  const double away =
      std::min({box.max().z() - place.z(), place.x() - box.min().x(), box.max().x() - place.x(),
                place.y() - box.min().y(), box.max().y() - place.y()});
  QVERIFY(std::abs(away) < 1e-6); // on a wall or the ceiling
  QVERIFY(find<QLabel>("planSaid")->text().startsWith(QLatin1String("With ")));
  QVERIFY(!find<QProgressBar>("planProgress")->isVisible());
  QCOMPARE(history().count(), 0);
  Camera elsewhere = plan().plannedCameras()[0];
  elsewhere.cameraFromWorld.translation().x() += 0.1;
  plan().changeCamera(0, elsewhere);
  QVERIFY(!find<QLabel>("planSaid")->isVisible()); // it was about the other place
}

void PlannerPageTest::aSearchCanBeCanceled() {
  find<QPushButton>("planFind")->click();
  QVERIFY(find<QPushButton>("planCancel")->isVisible());
  QVERIFY(!find<QPushButton>("planFind")->isEnabled());
  find<QPushButton>("planCancel")->click();
  QVERIFY(waitFor([&] { return !plan().positionSearchJob().isRunning(); }));
  QVERIFY(plan().plannedCameras().empty());
  QVERIFY(find<QPushButton>("planFind")->isEnabled());
}

/// No figure is required of a machine that does other things too; it is printed.
void PlannerPageTest::draggingStaysFluid() {
  showMap();
  find<QPushButton>("planAdd")->click();
  (void)view().currentImage();
  int maps = 0;
  connect(&plan(), &RigPlanner::mapChanged, this, [&] { ++maps; });
  for (const bool volume : {false, true}) {
    MapOptions look = plan().mapOptions();
    look.showsVolume = volume;
    plan().setMapOptions(look);
    QVERIFY(waitFor([&] { return view().mapOptions().showsVolume == volume && view().isDrawn(); }));
    // The least of some: what else the machine does comes and goes.
    double shown = 1e9, drawn = 1e9;
    for (int k = 0; k < 15; ++k) {
      QElapsedTimer own;
      own.start();
      (void)view().currentImage();
      drawn = std::min(drawn, 1e-6 * static_cast<double>(own.nsecsElapsed()));
      view().showMap(plan().map(), plan().mapOptions());
      own.restart();
      (void)view().currentImage();
      shown = std::min(shown, 1e-6 * static_cast<double>(own.nsecsElapsed()));
    }
    qInfo("a picture takes %.1f ms, with a new map %.1f ms", drawn, shown);
    EventLoopProbe probe;
    QVERIFY(waitFor([&] { return probe.ticks() > 0; })); // a stall before is not its own
    (void)probe.takeLongest();
    maps = 0;
    QElapsedTimer clock;
    clock.start();
    // As fast as a hand on a mouse, some 100 moves a second: the rate is what is measured.
    dragInView(placeInView(plan().plannedCameras()[0].center()), {-60.0, 40.0}, 100,
               [] { letTimePass(10); });
    const double rate = 1e3 * maps / static_cast<double>(clock.elapsed());
    qInfo("%s: %d maps, %.0f per second; longest stall of the window %.0f ms",
          volume ? "with surfaces" : "layer only", maps, rate, probe.takeLongest());
    QVERIFY(maps > 3);
  }
}

DEWPOINT_WINDOW_TEST(PlannerPageTest)

} // namespace dewpoint::tests

#include "planner_page_test.moc"
