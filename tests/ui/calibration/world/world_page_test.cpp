// SPDX-License-Identifier: GPL-3.0-or-later
// Floor, origin and scale in the real window: points marked in two images, and each step undone.
#include "tests/ui/calibration/calibration_window.h"
#include "tests/ui/mainwindow/small_picture.h"
#include "tests/ui/window_test.h"
#include "ui/cameraview/image_pick_overlay.h"
#include "ui/document/document.h"
#include "ui/workbench/dock_manager.h"
#include "ui/workbench/workbench.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>

#include <array>
#include <cmath>

namespace dewpoint::tests {

class WorldPageTest : public QObject, private test::CalibrationWindow {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup() { window_.reset(); }
  void threePointsSetTheFloor();
  void aMeasuredDistanceSetsTheScale();
  void theWorldIsTurnedUpright();
  void allCamerasMoveTogether();
  void markingEndsWithThePage();
  void withoutABoardTheFloorStays();

private:
  ImagePickOverlay* overlay(int k) {
    return find<ImagePickOverlay>(QStringLiteral("cameraView%1WorldMarks").arg(k));
  }
  QTableWidget* marks() { return find<QTableWidget>("worldMarks"); }
  void press(const char* button) { QTest::mouseClick(find<QPushButton>(button), Qt::LeftButton); }
  /// Marks a point in both images, where the present cameras see it.
  void mark(int row, const Eigen::Vector3d& world);
  /// The picture of the manual, into the folder that DEWPOINT_MANUAL names (docs/images).
  void keepPicture();
  /// Three points under the ball, all at one height.
  std::array<Eigen::Vector3d, 3> floorPoints();
};

void WorldPageTest::init() {
  openCalibration();
  find<QAction>("actionCalibrateWorld")->trigger();
  QVERIFY(find<QPushButton>("worldMark")->isChecked()); // ready to mark
}

void WorldPageTest::mark(int row, const Eigen::Vector3d& world) {
  marks()->setCurrentCell(row, 0);
  for (int k = 0; k < 2; ++k) {
    QTest::mouseClick(overlay(k), Qt::LeftButton, Qt::AltModifier,
                      placed(k, seen(k, world)).toPoint());
  }
}

std::array<Eigen::Vector3d, 3> WorldPageTest::floorPoints() {
  Eigen::Vector3d ball = window_->shown()->targets.at(0).truth.value();
  ball.z() = 0.0; // on the desk
  return {ball, ball + Eigen::Vector3d(0.08, 0.0, 0.0), ball + Eigen::Vector3d(0.0, 0.08, 0.0)};
}

void WorldPageTest::threePointsSetTheFloor() {
  const Camera before = camera(0);
  const auto points = floorPoints();
  QVERIFY(!find<QPushButton>("worldFloor")->isEnabled());
  for (int row = 0; row < 3; ++row) {
    mark(row, points[static_cast<std::size_t>(row)]);
    QCOMPARE(marks()->item(row, 1)->text(), QStringLiteral("2/2"));
  }
  QVERIFY(find<QPushButton>("worldFloor")->isEnabled());
  press("worldFloor");
  // Roughly: a click is where a whole pixel of the screen is, and the points are near each other.
  QVERIFY((camera(0).center() - (before.center() - points[0])).norm() < 0.2);
  QVERIFY(!find<QLabel>("worldResult")->text().isEmpty());
  // The marks stay where they are in the images. A is the origin now, B on the x axis, C on the
  // floor.
  const auto isZero = [this](int row, int column) {
    return std::abs(QLocale().toDouble(marks()->item(row, column)->text())) < 0.0015;
  };
  QVERIFY(isZero(0, 2) && isZero(0, 3) && isZero(0, 4));
  QVERIFY(!isZero(1, 2) && isZero(1, 3) && isZero(1, 4));
  QVERIFY(!isZero(2, 3) && isZero(2, 4));
  keepPicture();
  history().undo();
  QVERIFY((camera(0).center() - before.center()).norm() < 1e-12);
  QVERIFY(find<QLabel>("worldResult")->text().isEmpty());
}

void WorldPageTest::keepPicture() {
  const QString folder = qEnvironmentVariable("DEWPOINT_MANUAL");
  if (folder.isEmpty()) {
    return;
  }
  QVERIFY(settles(*window_));
  const QString file = folder + QStringLiteral("/calibration-floor.png");
  QVERIFY2(withFewerLevels(window_->grab().toImage()).save(file), qPrintable(file));
}

void WorldPageTest::aMeasuredDistanceSetsTheScale() {
  const auto points = floorPoints();
  mark(0, points[0]);
  mark(1, points[1]);
  auto* distance = find<QDoubleSpinBox>("worldDistance");
  QVERIFY(std::abs(distance->value() - 0.08) < 0.003); // what the cameras say now
  const double apart = (camera(0).center() - camera(1).center()).norm();
  const double factor = 0.5 / distance->value();
  distance->setValue(0.5);
  press("worldCheck");
  QVERIFY((camera(0).center() - camera(1).center()).norm() == apart); // nothing moved
  QVERIFY(project().worldRecord.lengthCheck.has_value());
  QCOMPARE(project().worldRecord.lengthCheck->measuredLength, 0.5);
  QVERIFY(!find<QLabel>("worldResult")->text().isEmpty());
  press("worldLength");
  const double now = (camera(0).center() - camera(1).center()).norm();
  QVERIFY(std::abs(now / apart / factor - 1.0) < 1e-2); // the field has four decimals
  QVERIFY(std::abs(distance->value() - 0.5) < 1e-3);
  press("worldClear");
  QCOMPARE(marks()->item(0, 1)->text(), QStringLiteral("0/2"));
  QVERIFY(!find<QPushButton>("worldLength")->isEnabled());
}

void WorldPageTest::theWorldIsTurnedUpright() {
  QVERIFY(!find<QPushButton>("worldUpright")->isVisible());
  const Eigen::Vector3d before = camera(0).center();
  press("worldQuarterX");
  press("worldQuarterX");
  QVERIFY((camera(0).center() - Eigen::Vector3d(before.x(), -before.y(), -before.z())).norm() <
          1e-9);
  QVERIFY(find<QPushButton>("worldUpright")->isVisible());
  QVERIFY(find<QLabel>("worldUprightText")->isVisible());
  press("worldUpright");
  QVERIFY((camera(0).center() - before).norm() < 1e-9);
  QVERIFY(!find<QPushButton>("worldUpright")->isVisible());
  for (int k = 0; k < 3; ++k) {
    history().undo();
  }
  QVERIFY((camera(0).center() - before).norm() < 1e-12);
}

void WorldPageTest::allCamerasMoveTogether() {
  const Eigen::Vector3d before = camera(1).center();
  find<QDoubleSpinBox>("worldShiftX")->setValue(1.5);
  find<QDoubleSpinBox>("worldTurn")->setValue(90.0);
  press("worldMove");
  const Eigen::Vector3d after(1.5 - before.y(), before.x(), before.z());
  QVERIFY((camera(1).center() - after).norm() < 1e-9);
  press("worldMove"); // the fields are empty now
  QVERIFY((camera(1).center() - after).norm() < 1e-9);
}

void WorldPageTest::markingEndsWithThePage() {
  QVERIFY(overlay(0)->isVisible());
  QTest::keyClick(overlay(0), Qt::Key_Escape);
  QVERIFY(!overlay(0)->isVisible());
  Q_EMIT window_->workbench()
      .docks.layoutChanged(); // whoever arranges views did not ask to mark points
  QVERIFY(!overlay(0)->isVisible());
  press("worldMark");
  QVERIFY(overlay(0)->isVisible());
  find<QAction>("actionCalibrateWand")->trigger();
  QVERIFY(!overlay(0)->isVisible()); // the grid has the mouse again
}

void WorldPageTest::withoutABoardTheFloorStays() {
  const auto before = window_->workbench().document.project().cameras;
  auto* text = find<QLabel>("worldBoardText");
  QVERIFY(!text->isVisible());
  scrollTo(find<QPushButton>("worldBoard"));
  press("worldBoard");
  QVERIFY(!find<QPushButton>("worldBoard")->isEnabled()); // until the search has ended
  QVERIFY(waitFor([&] { return find<QPushButton>("worldBoard")->isEnabled(); }));
  QVERIFY2(text->text().contains(QStringLiteral("No camera sees the board well enough")),
           qPrintable(text->text()));
  QVERIFY(window_->workbench().document.project().cameras == before);
}

DEWPOINT_WINDOW_TEST(WorldPageTest)

} // namespace dewpoint::tests

#include "world_page_test.moc"
