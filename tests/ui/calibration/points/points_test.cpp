// SPDX-License-Identifier: GPL-3.0-or-later
// Measured points in the real window: written into the table, clicked in the images, solved.
#include "core/calibration/manual/measured_points.h"
#include "tests/ui/calibration/calibration_window.h"
#include "tests/ui/window_test.h"

#include <QAction>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QSlider>
#include <QTableWidget>

#include <vector>

namespace dewpoint::tests {

class PointsTest : public QObject, private test::CalibrationWindow {
  Q_OBJECT

private Q_SLOTS:
  void init() { openCalibration(); }
  void cleanup() { window_.reset(); }
  void measuredPointsGiveTheCameraBack();
  void onlyAPointThatDoesNotFitIsMarked();
  void nothingMovesWhenResultsCome();
  void pointsOfOtherFramesAreFaint();
  void clickingEndsWithItsPage();
  void tooFewPointsSayHowManyAreNeeded();

private:
  QTableWidget* table() { return find<QTableWidget>("pointsList"); }
  QString result() { return find<QLabel>("pointAssessment")->text(); }
  /// Six positions around the ball.
  std::vector<Eigen::Vector3d> room();
  void type(int row, const Eigen::Vector3d& world);
  /// Adds points and clicks them where cameras see them.
  void enter(const std::vector<Eigen::Vector3d>& world, const std::vector<Camera>& cameras);
  void compute();
};

std::vector<Eigen::Vector3d> PointsTest::room() {
  std::vector<Eigen::Vector3d> world;
  for (const Eigen::Vector3d& offset :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(0.06, 0, 0.01), Eigen::Vector3d(0, 0.06, 0.03),
        Eigen::Vector3d(-0.05, 0.03, 0.05), Eigen::Vector3d(0.03, -0.05, -0.04),
        Eigen::Vector3d(0.04, 0.05, -0.03)}) {
    const Eigen::Vector3d ball = window_->shown()->targets.at(0).truth.value();
    // Millimeters, as the table shows them.
    world.push_back((1000.0 * (ball + offset)).array().round().matrix() / 1000.0);
  }
  return world;
}

void PointsTest::type(int row, const Eigen::Vector3d& world) {
  for (int axis = 0; axis < 3; ++axis) {
    table()->item(row, 1 + axis)->setText(QLocale().toString(world[axis], 'f', 3));
  }
}

void PointsTest::enter(const std::vector<Eigen::Vector3d>& world,
                       const std::vector<Camera>& cameras) {
  for (std::size_t k = 0; k < world.size(); ++k) {
    QTest::mouseClick(find<QPushButton>("pointAdd"), Qt::LeftButton);
    type(static_cast<int>(k), world[k]);
    QVERIFY((project().measuredPoints[k].world - world[k]).norm() < 1e-9);
    find<QPushButton>("pointClick")->click();
    for (int c = 0; c < 2; ++c) {
      const auto pixel = Projector(cameras[static_cast<std::size_t>(c)]).project(world[k]);
      QVERIFY(pixel.has_value());
      click(c, *pixel, Qt::AltModifier);
    }
    QTest::keyClick(layer(1), Qt::Key_Escape);
    QCOMPARE(project().measuredPoints[k].clicks.size(), std::size_t(2));
  }
}

void PointsTest::compute() {
  find<QPushButton>("pointSolve")->click();
  QVERIFY(waitFor([this] { return !result().isEmpty(); }));
}

void PointsTest::measuredPointsGiveTheCameraBack() {
  // Where points of the room are in the images as they are rendered.
  const std::vector<Camera> truth{camera(0), camera(1)};
  // Off by a decimeter each way.
  layer(0)->setFocus();
  QTest::keyClick(layer(0), Qt::Key_D, Qt::ShiftModifier);
  QTest::keyClick(layer(0), Qt::Key_W, Qt::ShiftModifier);
  QVERIFY((camera(0).center() - truth[0].center()).norm() > 0.1);

  enter(room(), truth);
  QVERIFY(table()->item(0, 5)->text().toDouble() > 5.0); // px, of the camera that is off
  compute();
  QVERIFY((camera(0).center() - truth[0].center()).norm() < 1e-3);
  QVERIFY((camera(1).center() - truth[1].center()).norm() < 1e-3);
  QVERIFY(table()->item(0, 5)->text().toDouble() < 0.1);
  history().undo(); // the solution is one step
  QVERIFY((camera(0).center() - truth[0].center()).norm() > 0.1);
  QVERIFY((camera(1).center() - truth[1].center()).norm() < 1e-9);
}

void PointsTest::onlyAPointThatDoesNotFitIsMarked() {
  const auto isMarked = [this](int row) {
    return table()->item(row, 0)->text().startsWith(QStringLiteral("▲"));
  };
  const auto world = room();
  enter(world, {camera(0), camera(1)});
  compute();
  QVERIFY2(result().contains(QStringLiteral("Largest error")), qPrintable(result()));
  for (int row = 0; row < table()->rowCount(); ++row) {
    QVERIFY(!isMarked(row)); // exact points have a worst one, too
  }
  constexpr int kWrong = 3;
  type(kWrong, world[kWrong] + Eigen::Vector3d(0.1, 0.0, 0.0));
  QVERIFY(result().isEmpty());
  compute();
  for (int row = 0; row < table()->rowCount(); ++row) {
    QCOMPARE(isMarked(row), row == kWrong);
  }
}

/// Else the next click or the next number goes to another place than it is meant for.
void PointsTest::nothingMovesWhenResultsCome() {
  const auto places = [this] {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    std::vector<QPoint> all{table()->mapTo(window_.get(), QPoint()),
                            find<QPushButton>("pointSolve")->mapTo(window_.get(), QPoint())};
    for (int column = 0; column < table()->columnCount(); ++column) {
      all.emplace_back(table()->columnViewportPosition(column), table()->columnWidth(column));
    }
    return all;
  };
  const auto world = room();
  enter(world, {camera(0), camera(1)});
  compute();
  QVERIFY(keepsItsSize(table())); // the result has been scrolled to
  const auto with = places();
  type(0, world[0] + Eigen::Vector3d(-0.001, 0.0, 0.0));
  QVERIFY(result().isEmpty());
  QVERIFY(keepsItsSize(table()));
  QVERIFY(places() == with);
  compute();
  QVERIFY(keepsItsSize(table()));
  QVERIFY(places() == with);
  QVERIFY(!find<QWidget>("guideStrip")->isVisible()); // of the guide, which nobody follows
}

void PointsTest::pointsOfOtherFramesAreFaint() {
  QVERIFY(shown().frameCount); // a recording
  const std::int64_t frame = shown().frame;
  enter({room().front()}, {camera(0), camera(1)});
  for (const PointClick& one : project().measuredPoints[0].clicks) {
    QVERIFY(one.frame == frame);
  }
  find<QPushButton>("pointAdd")->click(); // the selected point is never faint
  const auto picture = [this] { return layer(0)->parentWidget()->grab().toImage(); };
  find<QSlider>("gridOpacity")->setValue(0);
  action("actionNextFrame")->trigger();
  QVERIFY(waitFor([&] { return shown().frame > frame; }));
  QVERIFY(isClickedOnlyInOtherFrames(project().measuredPoints[0], shown().frame));
  QVERIFY(draws(*layer(0)->parentWidget()));
  const QImage faint = picture();
  QVERIFY(window_->document().edit(QStringLiteral("clicked now"), [this](Project& project) {
    for (PointClick& one : project.measuredPoints[0].clicks) {
      one.frame = shown().frame;
    }
  }));
  QVERIFY(picture() != faint);
  const auto strength = [](bool isInOtherFrames) {
    QImage image(60, 60, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    PaintedPoint point;
    point.click = QPointF(30.0, 30.0);
    point.isInOtherFrames = isInOtherFrames;
    paintPoints(painter, {point});
    return qAlpha(image.pixel(30, 30));
  };
  QVERIFY(strength(true) > 0);
  QVERIFY(strength(true) < strength(false));
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
  QVERIFY(waitFor([this] { return !result().isEmpty(); }));
  QVERIFY2(result().contains(QStringLiteral("1 point")), qPrintable(result()));
  QVERIFY2(result().contains(QString::number(kFewestPointsOfPose)), qPrintable(result()));
}

DEWPOINT_WINDOW_TEST(PointsTest)

} // namespace dewpoint::tests

#include "points_test.moc"
