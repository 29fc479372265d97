// SPDX-License-Identifier: GPL-3.0-or-later
// Measured points in the real window: written into the table, clicked in the images, solved.
#include "core/calibration/manual/measured_points.h"
#include "tests/ui/calibration/calibration_window.h"
#include "tests/ui/window_test.h"

#include <QAction>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>

#include <vector>

namespace dewpoint::tests {

class PointsTest : public QObject, private test::CalibrationWindow {
  Q_OBJECT

private Q_SLOTS:
  void init() { openCalibration(); }
  void cleanup() { window_.reset(); }
  void measuredPointsGiveTheCameraBack();
  void clickingEndsWithItsPage();
  void tooFewPointsSayHowManyAreNeeded();
};

void PointsTest::measuredPointsGiveTheCameraBack() {
  // Where points of the room are in the images as they are rendered.
  const std::vector<Camera> truth{camera(0), camera(1)};
  std::vector<Eigen::Vector3d> world;
  for (const Eigen::Vector3d& offset :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.06, 0, 0.01), Eigen::Vector3d(0, 0.06, 0.03),
        Eigen::Vector3d(-0.05, 0.03, 0.05), Eigen::Vector3d(0.03, -0.05, -0.04),
        Eigen::Vector3d(0.04, 0.05, -0.03)}) {
    const Eigen::Vector3d ball = window_->shown()->targets.at(0).truth.value();
    // Millimeters, as the table shows them.
    world.push_back((1000.0 * (ball + offset)).array().round().matrix() / 1000.0);
  }
  // Off by a decimeter each way.
  layer(0)->setFocus();
  QTest::keyClick(layer(0), Qt::Key_D, Qt::ShiftModifier);
  QTest::keyClick(layer(0), Qt::Key_W, Qt::ShiftModifier);
  QVERIFY((camera(0).center() - truth[0].center()).norm() > 0.1);

  auto* table = find<QTableWidget>("pointsList");
  for (std::size_t k = 0; k < world.size(); ++k) {
    QTest::mouseClick(find<QPushButton>("pointAdd"), Qt::LeftButton);
    const int row = static_cast<int>(k);
    for (int axis = 0; axis < 3; ++axis) {
      table->item(row, 1 + axis)->setText(QLocale().toString(world[k][axis], 'f', 3));
    }
    QVERIFY((project().points[k].world - world[k]).norm() < 1e-9);
    find<QPushButton>("pointClick")->click();
    for (int c = 0; c < 2; ++c) {
      const auto pixel = Projector(truth[static_cast<std::size_t>(c)]).project(world[k]);
      QVERIFY(pixel.has_value());
      click(c, *pixel, Qt::AltModifier);
    }
    QTest::keyClick(layer(1), Qt::Key_Escape);
    QCOMPARE(project().points[k].clicks.size(), std::size_t(2));
  }
  QVERIFY(table->item(0, 5)->text().toDouble() > 5.0); // px, of the camera that is off
  QTest::mouseClick(find<QPushButton>("pointSolve"), Qt::LeftButton);
  QVERIFY(waitFor([&] { return !find<QLabel>("pointAssessment")->text().isEmpty(); }));
  QVERIFY((camera(0).center() - truth[0].center()).norm() < 1e-3);
  QVERIFY((camera(1).center() - truth[1].center()).norm() < 1e-3);
  QVERIFY(table->item(0, 5)->text().toDouble() < 0.1);
  history().undo(); // the solution is one step
  QVERIFY((camera(0).center() - truth[0].center()).norm() > 0.1);
  QVERIFY((camera(1).center() - truth[1].center()).norm() < 1e-9);
}

void PointsTest::clickingEndsWithItsPage() {
  find<QPushButton>("pointAdd")->click();
  auto* clicking = find<QPushButton>("pointClick");
  clicking->click();
  QVERIFY(clicking->isChecked());
  find<QAction>("actionCalibrateWand")->trigger();
  QVERIFY(!clicking->isChecked());
}

void PointsTest::tooFewPointsSayHowManyAreNeeded() {
  find<QPushButton>("pointAdd")->click();
  find<QPushButton>("pointClick")->click();
  click(0, Eigen::Vector2d(100.0, 100.0), Qt::AltModifier);
  find<QPushButton>("pointSolve")->click();
  QVERIFY(!find<QPushButton>("pointClick")->isChecked()); // the next click moves no point
  const auto text = [this] { return find<QLabel>("pointAssessment")->text(); };
  QVERIFY(waitFor([&] { return !text().isEmpty(); }));
  QVERIFY2(text().contains(QStringLiteral("1 point")), qPrintable(text()));
  QVERIFY2(text().contains(QString::number(kFewestPointsOfPose)), qPrintable(text()));
}

DEWPOINT_WINDOW_TEST(PointsTest)

} // namespace dewpoint::tests

#include "points_test.moc"
