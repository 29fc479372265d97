// SPDX-License-Identifier: GPL-3.0-or-later
// Adjusting cameras by hand in the real window: mouse and keys as a person would use them.
#include "tests/ui/calibration/calibration_window.h"
#include "tests/ui/window_test.h"
#include "ui/view3d/birds_eye_view.h"
#include "ui/workbench/view_dock.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSlider>
#include <QTableWidget>
#include <QWheelEvent>

#include <set>

namespace dewpoint::tests {

class CalibrationTest : public QObject, private test::CalibrationWindow {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup();
  void opensAsAModeOfTheWindow();
  void theViewBeforeComesBack();
  void theGridFollowsTheMouse();
  void heldPointsStay();
  void keysNudgeInNamedSteps();
  void fieldsShowAndSet();
  void theGridIsPartOfTheProject();
  void flipShowsBefore();
  void theBirdsEyeViewMovesCameras();
  void spacePressesWhatHasTheFocus();
  void theRunGoesOn();
  void theWheelScrollsThePage();
  void everythingHasAName();
  void theMenuNamesBoardAndWandAlike();
};

void CalibrationTest::init() {
  openCalibration();
}

void CalibrationTest::cleanup() {
  window_.reset();
}

void CalibrationTest::opensAsAModeOfTheWindow() {
  QVERIFY(find<QDockWidget>("calibrationDock")->isVisible());
  QVERIFY(find<QAction>("actionCalibrateByHand")->isChecked());
  QVERIFY(layer(0)->isVisible());
  QVERIFY(QApplication::activeModalWidget() == nullptr);
  QCOMPARE(history().count(), 0);
  QVERIFY(crossings(0).size() >= 4);
  // Something is drawn: the layer is not the same with another opacity.
  find<QSlider>("gridOpacity")->setValue(100);
  QVERIFY(draws(*layer(0)->parentWidget())); // else it differs by the image that comes
  const QImage strong = layer(0)->parentWidget()->grab().toImage();
  find<QSlider>("gridOpacity")->setValue(0);
  QVERIFY(layer(0)->parentWidget()->grab().toImage() != strong);
  QTest::keyClick(window_.get(), Qt::Key_C);
  QVERIFY(!layer(0)->isVisible());
  QVERIFY(!find<QDockWidget>("calibrationDock")->isVisible());
}

void CalibrationTest::theViewBeforeComesBack() {
  auto* parameters = find<ViewDock>("parameterDock");
  const auto toggle = [this] { QTest::keyClick(window_.get(), Qt::Key_C); };
  toggle();
  parameters->raise();
  QVERIFY(waitFor([&] { return !parameters->isBehindOtherDocks(); }));
  toggle();
  QVERIFY(waitFor([&] { return parameters->isBehindOtherDocks(); }));
  toggle();
  QVERIFY(waitFor([&] { return !parameters->isBehindOtherDocks(); }));
}

void CalibrationTest::theGridFollowsTheMouse() {
  const Eigen::Vector3d point = crossings(0).front();
  const Eigen::Vector2d from = seen(0, point);
  const Eigen::Vector2d to = from + Eigen::Vector2d(13.0, 9.0);
  const Camera before = camera(0);
  drag(0, from, to);
  QVERIFY((seen(0, point) - to).norm() < 0.5);
  QVERIFY((camera(0).center() - before.center()).norm() < 1e-9); // it turned
  QCOMPARE(history().count(), 1);
  QVERIFY(history().undoText().contains(QString::fromStdString(before.name)));
  history().undo();
  QVERIFY(camera(0) == before);
  history().redo();
  QVERIFY((seen(0, point) - to).norm() < 0.5);
  // Sliding keeps the direction.
  find<QComboBox>("handDragMode")->setCurrentIndex(1);
  const Camera rotatedCamera = camera(0);
  drag(0, to, from);
  QVERIFY((seen(0, point) - from).norm() < 0.5);
  QVERIFY((camera(0).opticalAxis() - rotatedCamera.opticalAxis()).norm() < 1e-9);
  // Escape in the middle of a drag: as it was, and no step.
  const int steps = history().count();
  const Camera present = camera(0);
  mouse(0, QEvent::MouseButtonPress, from);
  mouse(0, QEvent::MouseMove, from + Eigen::Vector2d(25.0, 5.0));
  QVERIFY(!(camera(0) == present));
  QTest::keyClick(layer(0), Qt::Key_Escape);
  QVERIFY(camera(0) == present);
  QCOMPARE(history().count(), steps);
}

void CalibrationTest::heldPointsStay() {
  const auto points = crossings(0);
  const Eigen::Vector3d held = points.front();
  const Eigen::Vector3d second = points[points.size() / 2];
  const Eigen::Vector3d moved = points.back();
  const Eigen::Vector2d heldAt = seen(0, held);
  click(0, heldAt);
  const Eigen::Vector2d to = seen(0, moved) + Eigen::Vector2d(6.0, -5.0);
  drag(0, seen(0, moved), to);
  QVERIFY((seen(0, held) - heldAt).norm() < 1e-6);
  QVERIFY((seen(0, moved) - to).norm() < 0.5);
  const Eigen::Vector2d secondAt = seen(0, second);
  click(0, secondAt);
  drag(0, seen(0, moved), to + Eigen::Vector2d(-4.0, 2.0));
  QVERIFY((seen(0, held) - heldAt).norm() < 1e-6);
  QVERIFY((seen(0, second) - secondAt).norm() < 1e-6);
  // Clicked again the pins are gone: a drag turns about the camera's center.
  click(0, heldAt);
  click(0, secondAt);
  const Camera before = camera(0);
  drag(0, seen(0, moved), seen(0, moved) + Eigen::Vector2d(8.0, 0.0));
  QVERIFY((camera(0).center() - before.center()).norm() < 1e-9);
}

void CalibrationTest::keysNudgeInNamedSteps() {
  layer(1)->setFocus();
  const Camera before = camera(1);
  const Eigen::Vector3d right = before.cameraFromWorld.linear().row(0);
  const bool evidence = find<QAction>("actionShowEvidence")->isChecked();
  QTest::keyClick(layer(1), Qt::Key_D);
  QVERIFY((camera(1).center() - before.center() - 0.01 * right).norm() < 1e-12);
  QCOMPARE(history().undoText(), QStringLiteral("%1 +1.0 cm right").arg(before.name.c_str()));
  QTest::keyClick(layer(1), Qt::Key_D, Qt::ShiftModifier);
  QVERIFY((camera(1).center() - before.center() - 0.11 * right).norm() < 1e-12);
  QTest::keyClick(layer(1), Qt::Key_Right, Qt::ControlModifier);
  QVERIFY((camera(1).center() - before.center() - 0.111 * right).norm() < 1e-12);
  QTest::keyClick(layer(1), Qt::Key_E);
  QCOMPARE(find<QAction>("actionShowEvidence")->isChecked(), evidence);
  QCOMPARE(history().count(), 4);
  find<QComboBox>("handKeyFrame")->setCurrentIndex(1);
  QTest::keyClick(layer(1), Qt::Key_Left);
  QCOMPARE(history().undoText(), QStringLiteral("%1 -1.0 cm x").arg(before.name.c_str()));
  find<QComboBox>("handKeyMode")->setCurrentIndex(1);
  const Heading heading = headingOf(camera(1));
  QTest::keyClick(layer(1), Qt::Key_A);
  QVERIFY(std::abs(headingOf(camera(1)).yaw - heading.yaw - 0.2 * M_PI / 180.0) < 1e-9);
  QTest::keyClick(layer(1), Qt::Key_Plus);
  QVERIFY(std::abs(camera(1).intrinsics.focalX / before.intrinsics.focalX - 1.01) < 1e-12);
  while (history().canUndo()) {
    QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  }
  QVERIFY(camera(1) == before);
}

void CalibrationTest::fieldsShowAndSet() {
  find<QComboBox>("handCamera")->activated(0);
  auto* x = find<QDoubleSpinBox>("handPositionX");
  const Camera before = camera(0);
  QVERIFY(std::abs(x->value() - before.center().x()) < 1e-3);
  find<QComboBox>("handUnit")->setCurrentIndex(1);
  QVERIFY(std::abs(x->value() - 100.0 * before.center().x()) < 0.1);
  x->setFocus();
  x->selectAll();
  QTest::keyClicks(x, QStringLiteral("12.5"));
  QTest::keyClick(x, Qt::Key_Return);
  QVERIFY(std::abs(camera(0).center().x() - 0.125) < 1e-12);
  QVERIFY(history().undoText().contains(QStringLiteral("12.5 cm")));
  find<QComboBox>("handAimMode")->setCurrentIndex(1);
  const auto* yaw = find<QDoubleSpinBox>("handAimX");
  const auto* roll = find<QDoubleSpinBox>("handRoll");
  QCOMPARE(yaw->prefix(), QStringLiteral("yaw "));
  QCOMPARE(find<QDoubleSpinBox>("handAimY")->prefix(), QStringLiteral("pitch "));
  QVERIFY(waitFor([&] { return roll->y() == yaw->y() && roll->x() > yaw->x(); })); // one row
  find<QDoubleSpinBox>("handRoll")->setValue(3.0);
  QVERIFY(std::abs(headingOf(camera(0)).roll - 3.0 * M_PI / 180.0) < 1e-9);
  find<QDoubleSpinBox>("handAimX")->setValue(40.0); // yaw
  QVERIFY(std::abs(headingOf(camera(0)).yaw - 40.0 * M_PI / 180.0) < 1e-9);
  QCOMPARE(history().undoText().count(QStringLiteral("yaw")), 1);
  find<QComboBox>("handLensMode")->setCurrentIndex(1);
  find<QDoubleSpinBox>("handLens")->setValue(60.0);
  QVERIFY(std::abs(fieldOfView(camera(0)) - M_PI / 3.0) < 1e-9);
  QCOMPARE(history().count(), 4);
}

void CalibrationTest::theGridIsPartOfTheProject() {
  QVERIFY(!project().grid);
  find<QComboBox>("gridKind")->activated(2);
  find<QDoubleSpinBox>("gridSizeX")->setValue(3.0);
  QVERIFY(project().grid);
  QCOMPARE(project().grid->kind, GridKind::Box);
  QCOMPARE(project().grid->size.x(), 3.0);
  // Refused: more lines than can be drawn; the field shows what holds.
  find<QDoubleSpinBox>("gridStep")->setValue(0.001);
  QCOMPARE(project().grid->step, grid_.step);
  QCOMPARE(find<QDoubleSpinBox>("gridStep")->value(), grid_.step);
  history().undo();
  history().undo();
  QVERIFY(!project().grid);
}

void CalibrationTest::flipShowsBefore() {
  QWidget* view = layer(0)->parentWidget();
  view->grab();
  const QImage before = layer(0)->grab().toImage();
  const auto point = crossings(0).front();
  drag(0, seen(0, point), seen(0, point) + Eigen::Vector2d(20.0, 10.0));
  QVERIFY(layer(0)->grab().toImage() != before);
  auto* flip = find<QPushButton>("gridFlip");
  QTest::mousePress(flip, Qt::LeftButton);
  const QImage held = layer(0)->grab().toImage();
  QTest::mouseRelease(flip, Qt::LeftButton);
  const QImage now = layer(0)->grab().toImage();
  QVERIFY(held != now);
  QCOMPARE(history().count(), 1);
}

void CalibrationTest::theBirdsEyeViewMovesCameras() {
  auto* view = find<BirdsEyeView>("birdsEyeView");
  view->lookFromAbove();
  QVERIFY(waitFor([view] { return view->isDrawn(); }));
  if (!view->hasImage()) {
    QSKIP("no OpenGL");
  }
  const Camera before = camera(0);
  const auto placeIn = [&](const Eigen::Vector3d& point) {
    const Eigen::Vector2d at = view->scene().projectToImage(point) / view->devicePixelRatioF();
    return QPoint(int(std::lround(view->width() / 2.0 + at.x())),
                  int(std::lround(view->height() / 2.0 - at.y())));
  };
  const QPoint from = placeIn(before.center());
  QVERIFY(view->rect().contains(from));
  const double scale = view->scene().metersPerPixel() * view->devicePixelRatioF();
  QTest::mousePress(view, Qt::LeftButton, {}, from);
  QTest::mouseMove(view, from + QPoint(10, 0));
  QTest::mouseMove(view, from + QPoint(20, -10));
  QTest::mouseRelease(view, Qt::LeftButton, {}, from + QPoint(20, -10));
  // With the focus, too, the picture is there: not one color all over.
  QVERIFY(view->hasFocus());
  const QImage picture = view->grab().toImage();
  std::set<QRgb> colors;
  for (int x = 0; x < picture.width(); ++x) {
    colors.insert(picture.pixel(x, picture.height() / 3));
  }
  QVERIFY(colors.size() > 4);
  const Eigen::Vector3d moved = camera(0).center() - before.center();
  QVERIFY(std::abs(moved.x() - 20.0 * scale) < 1.5 * scale);
  QVERIFY(std::abs(moved.y() - 10.0 * scale) < 1.5 * scale);
  QVERIFY(std::abs(moved.z()) < 1e-9);
  QVERIFY((camera(0).opticalAxis() - before.opticalAxis()).norm() < 1e-9);
  QCOMPARE(history().count(), 1);
  history().undo();
  QVERIFY(camera(0) == before);
}

void CalibrationTest::spacePressesWhatHasTheFocus() {
  auto* edges = find<QCheckBox>("gridEdges");
  const bool checked = edges->isChecked();
  edges->setFocus();
  QTest::keyClick(edges, Qt::Key_Space);
  QCOMPARE(edges->isChecked(), !checked);
  letTimePass(200); // elsewhere the same key plays
  QCOMPARE(window_->shown()->state, PlayState::Paused);
}

void CalibrationTest::theRunGoesOn() {
  QTest::keyClick(window_.get(), Qt::Key_Space);
  QVERIFY(waitFor([&] { return window_->shown()->frame >= 10; }));
  const auto iterations = window_->shown()->iterationCount;
  const Camera before = camera(0);
  layer(0)->setFocus();
  QTest::keyClick(layer(0), Qt::Key_D, Qt::ShiftModifier);
  QVERIFY(waitFor(
      [&] { return window_->shown()->rig && window_->shown()->rig->front() == camera(0); }));
  QVERIFY(window_->shown()->iterationCount >= iterations); // nothing started over
  QVERIFY((window_->shown()->rig->front().center() - before.center()).norm() > 0.09);
}

void CalibrationTest::theWheelScrollsThePage() {
  auto* mode = find<QComboBox>("handDragMode");
  window_->setFocus();
  const QPointF at = mode->rect().center();
  QWheelEvent wheel(at, mode->mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(mode, &wheel);
  QCOMPARE(mode->currentIndex(), 0);
}

void CalibrationTest::everythingHasAName() {
  const auto* place = find<QWidget>("calibrationPlace");
  for (QWidget* control : place->findChildren<QWidget*>()) {
    const bool isField = qobject_cast<QAbstractSpinBox*>(control) ||
                         qobject_cast<QComboBox*>(control) || qobject_cast<QSlider*>(control) ||
                         qobject_cast<QTableWidget*>(control);
    const bool isButton =
        qobject_cast<QAbstractButton*>(control) != nullptr && !control->objectName().isEmpty() &&
        !control->objectName().startsWith(QLatin1String("qt_")) && control->isVisible();
    if (isField) {
      QVERIFY2(!control->accessibleName().isEmpty(), qPrintable(control->objectName()));
    }
    if (isField || isButton) {
      QVERIFY2(!control->toolTip().isEmpty(), qPrintable(control->objectName()));
      QVERIFY2(control->focusPolicy() & Qt::TabFocus || isButton,
               qPrintable(control->objectName()));
    }
  }
}

void CalibrationTest::theMenuNamesBoardAndWandAlike() {
  QCOMPARE(find<QAction>("actionCalibrateBoard")->text(),
           QStringLiteral("Calibrate with a board…"));
  QCOMPARE(find<QAction>("actionCalibrateWand")->text(), QStringLiteral("Calibrate with a wand…"));
}

DEWPOINT_WINDOW_TEST(CalibrationTest)

} // namespace dewpoint::tests

#include "calibration_test.moc"
