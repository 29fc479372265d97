// SPDX-License-Identifier: GPL-3.0-or-later
// What clicks and single keys mean while the calibration panel is open, and what "Before" shows.
#include "core/base/angle.h"
#include "tests/ui/calibration/calibration_window.h"
#include "tests/ui/window_test.h"
#include "ui/calibration/manual_calibration.h"
#include "ui/cameraview/image_pick_overlay.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>

#include <algorithm>

namespace dewpoint::tests {

class CalibrationClicksTest : public QObject, private test::CalibrationWindow {
  Q_OBJECT

private Q_SLOTS:
  void init() { openCalibration(); }
  void cleanup() { window_.reset(); }
  void noHintAboutColorsOnThePages();
  void aColorCanBeLearnedWhileThePanelIsOpen();
  void aDoubleClickBesideTheGridFits();
  void escapeReleasesTheHeldPointsOfAllImages();
  void beforeShowsTheChosenCameras();
  void beforeSaysThatItsGridIsOutOfSight();
  void singleKeysStayInThePanel();

private:
  ImagePickOverlay* overlay(int k) {
    return find<ImagePickOverlay>(QStringLiteral("cameraView%1Pick").arg(k));
  }
  CameraView* view(int k) { return static_cast<CameraView*>(layer(k)->parentWidget()); }
  void press(const char* button) { find<QPushButton>(button)->click(); }
  /// A place in the image of camera 0 that is far from each point of the grid.
  QPointF besideTheGrid();
};

void CalibrationClicksTest::noHintAboutColorsOnThePages() {
  QVERIFY(window_->document().edit(QStringLiteral("no target"),
                                   [](Project& project) { project.targets.clear(); }));
  for (const char* page :
       {"actionCalibrate", "actionCalibrateBoard", "actionCalibrateWand", "actionCalibrateWorld"}) {
    action(page)->trigger();
    QVERIFY2(overlay(0)->shownHint().isEmpty(), page);
  }
  action("actionCalibrateByHand")->setChecked(false);
  QVERIFY(!overlay(0)->shownHint().isEmpty()); // the next click is for the color
  action("actionLearnColor")->setChecked(true);
  action("actionCalibrateByHand")->setChecked(true);
  QVERIFY(!action("actionLearnColor")->isChecked());
  QVERIFY(overlay(0)->shownHint().isEmpty());
}

/// As for the ball of a wand: the images belong to the tool that was chosen last.
void CalibrationClicksTest::aColorCanBeLearnedWhileThePanelIsOpen() {
  action("actionLearnColor")->setChecked(true);
  QVERIFY(!overlay(0)->shownHint().isEmpty());
  QVERIFY(!layer(0)->isVisible()); // else it would take the click
  action("actionLearnColor")->setChecked(false);
  QVERIFY(layer(0)->isVisible());
  press("pointAdd");
  press("pointClick");
  action("actionLearnColor")->setChecked(true);
  QVERIFY(!find<QPushButton>("pointClick")->isChecked());
  press("pointClick");
  QVERIFY(!action("actionLearnColor")->isChecked());
  QVERIFY(layer(0)->isVisible());
}

QPointF CalibrationClicksTest::besideTheGrid() {
  const Intrinsics& image = camera(0).intrinsics;
  const Projector projector(camera(0));
  for (double y = 5.0; y < image.height - 5.0; y += 2.0) {
    for (double x = 5.0; x < image.width - 5.0; x += 2.0) {
      const QPointF at = placed(0, {x, y});
      if (!geometry::gridCrossingAt(camera(0), grid_, {x, y}, 10.0 / view(0)->placement().scale) &&
          layer(0)->rect().contains(at.toPoint())) {
        return at;
      }
    }
  }
  qFatal("no place of camera 0 is beside the grid");
}

void CalibrationClicksTest::aDoubleClickBesideTheGridFits() {
  const QRectF area = view(0)->shownArea();
  view(0)->zoomBy(1.3, area.center());
  QVERIFY(view(0)->isZoomed());
  const QPoint on = placed(0, seen(0, crossings(0).front())).toPoint();
  QTest::mouseDClick(layer(0), Qt::LeftButton, {}, on); // two clicks on a point of the grid
  QVERIFY(view(0)->isZoomed());
  auto* manual = window_->findChild<ManualCalibration*>();
  const auto pins = manual->pins(0).size();
  QTest::mouseDClick(layer(0), Qt::LeftButton, {}, besideTheGrid().toPoint());
  QVERIFY(!view(0)->isZoomed());
  QCOMPARE(manual->pins(0).size(), pins); // none is left by the first of the two clicks
  QCOMPARE(history().count(), 0);
}

void CalibrationClicksTest::escapeReleasesTheHeldPointsOfAllImages() {
  auto* manual = window_->findChild<ManualCalibration*>();
  const auto holdBoth = [this, manual] {
    for (int k = 0; k < 2; ++k) {
      click(k, seen(k, crossings(k).front()));
      QCOMPARE(manual->pins(k).size(), std::size_t{1});
    }
  };
  manual->clearPins();
  holdBoth();
  QTest::keyClick(layer(1), Qt::Key_Escape);
  QVERIFY(!manual->hasPins());
  holdBoth();
  auto* list = find<QComboBox>("gridCompare"); // in the panel
  QVERIFY(list->isVisible());
  list->setFocus();
  QTest::keyClick(list, Qt::Key_Escape);
  QVERIFY(!manual->hasPins());
}

void CalibrationClicksTest::beforeSaysThatItsGridIsOutOfSight() {
  auto* manual = window_->findChild<ManualCalibration*>();
  const Camera facing = camera(0);
  QVERIFY(manual->setGrid(QStringLiteral("grid"), grid_, {}));
  QVERIFY(layer(0)->shownLabel().isEmpty());
  manual->showEarlierCameras(EarlierCameras::LastChange);
  QCOMPARE(layer(0)->shownLabel(), QStringLiteral("before"));
  manual->showEarlierCameras({});
  manual->changeCamera(0, QStringLiteral("away"),
                       rotated(facing, {0.0, 0.0, 180.0 * base::kDegree}, NudgeFrame::World));
  manual->changeCamera(0, QStringLiteral("back"), facing);
  manual->showEarlierCameras(EarlierCameras::LastChange);
  QVERIFY(layer(0)->shownLabel().contains(QStringLiteral("outside")));
}

void CalibrationClicksTest::beforeShowsTheChosenCameras() {
  auto* manual = window_->findChild<ManualCalibration*>();
  auto* flip = find<QPushButton>("gridFlip");
  auto* choice = find<QComboBox>("gridCompare");
  const Camera first = camera(0);
  const auto point = crossings(0).front();
  drag(0, seen(0, point), seen(0, point) + Eigen::Vector2d(20.0, 10.0));
  const Camera second = camera(0);
  drag(0, seen(0, point), seen(0, point) + Eigen::Vector2d(-5.0, 8.0));
  const Camera third = camera(0);
  QVERIFY(!(second == first) && !(third == second));
  const auto held = [&](int index) {
    choice->setCurrentIndex(index);
    QTest::mousePress(flip, Qt::LeftButton);
    const Camera shown = manual->shownCamera(0);
    QTest::mouseRelease(flip, Qt::LeftButton);
    return shown;
  };
  QVERIFY(held(0) == first);
  QVERIFY(held(1) == second); // before the last drag, however many moves it had
  QVERIFY(manual->shownCamera(0) == third);
  // Another page of the panel, and back: it was opened only once.
  action("actionCalibrateBoard")->trigger();
  action("actionCalibrateByHand")->trigger();
  QVERIFY(layer(0)->isVisible());
  QVERIFY(held(0) == first);
  action("actionCalibrateByHand")->setChecked(false);
  action("actionCalibrateByHand")->setChecked(true);
  QVERIFY(held(0) == third);
}

void CalibrationClicksTest::singleKeysStayInThePanel() {
  const QAction* mask = action("actionShowMask");
  const bool shown = mask->isChecked();
  auto* button = find<QPushButton>("pointAdd");
  button->click();
  button->setFocus();
  const auto iterations = window_->shown()->iterationCount;
  for (const Qt::Key key : {Qt::Key_M, Qt::Key_C, Qt::Key_I, Qt::Key_R, Qt::Key_Period}) {
    QTest::keyClick(button, key);
    QTest::keyClick(button, key, Qt::ShiftModifier);
  }
  letTimePass();
  QCOMPARE(mask->isChecked(), shown);
  QCOMPARE(window_->shown()->iterationCount, iterations);
  QVERIFY(find<QDockWidget>("calibrationDock")->isVisible());
  // In a list, a letter begins the name that is typed.
  auto* table = find<QTableWidget>("pointsList");
  table->setFocus();
  table->setCurrentCell(0, 0);
  QTest::keyClick(table, Qt::Key_M);
  QCOMPARE(mask->isChecked(), shown);
  auto* editor = table->viewport()->findChild<QLineEdit*>();
  QVERIFY(editor != nullptr);
  QTest::keyClick(editor, Qt::Key_Escape);
  // Keys with Ctrl act everywhere, single keys outside the panel.
  QVERIFY(history().canUndo());
  QTest::keyClick(button, Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(!history().canUndo());
  layer(0)->setFocus();
  QTest::keyClick(layer(0), Qt::Key_M);
  QCOMPARE(mask->isChecked(), !shown);
  QTest::keyClick(layer(0), Qt::Key_C);
  QVERIFY(!find<QDockWidget>("calibrationDock")->isVisible());
}

DEWPOINT_WINDOW_TEST(CalibrationClicksTest)

} // namespace dewpoint::tests

#include "calibration_clicks_test.moc"
