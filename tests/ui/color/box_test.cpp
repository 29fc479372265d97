// SPDX-License-Identifier: GPL-3.0-or-later
// Methods that follow boxes, in the window: one video, no calibration, a click.
#include "core/base/text_file.h"
#include "tests/tracking/moving_patch.h"
#include "tests/ui/color/box_window.h"
#include "tests/ui/window_test.h"
#include "ui/cameraview/camera_view.h"
#include "ui/document/document.h"
#include "ui/export/box_export_dialog.h"
#include "ui/selection/selection.h"
#include "ui/style/theme.h"
#include "ui/trajectory/box_model.h"
#include "ui/widgets/message_bar.h"

#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QUndoStack>

namespace dewpoint::tests {

class BoxTest : public QObject, private BoxWindow {
  Q_OBJECT

private Q_SLOTS:
  void initTestCase() { record(); }
  void init() { open(); }
  void cleanup() { close(); }
  void oneVideoWithoutACalibrationIsFollowedAfterAClick();
  void aDraggedBoxIsAStepThatCanBeUndone();
  void whatIsSavedIsOpenedAgainWithItsBox();
  void lookingBackShowsTheBoxAsItWas();
  void boxesAreExported();
  void theMethodIsChosenInTheParameters();
};

void BoxTest::oneVideoWithoutACalibrationIsFollowedAfterAClick() {
  openVideo();
  QCOMPARE(window_->document().project().method, std::string("histogram"));
  QVERIFY(find<QDockWidget>("birdsEyeDock")->isHidden()); // there is nothing in space
  QVERIFY(!action("actionShowMask")->isEnabled());
  clickAt(MovingPatch{}.box(0).center());
  QVERIFY(isTrackedTo(kFrames - 1)); // the first click starts tracking
  QVERIFY(hasBox());
  const ImageBox truth = MovingPatch{}.box(kFrames - 1);
  const ImageBox found = first()->box()->box;
  QVERIFY((found.center() - truth.center()).norm() < 12.0); // of a patch of 30 px
  QCOMPARE(window_->document().undoStack()->undoText(), QStringLiteral("Box of target 1"));
  // It is drawn in the color of the first target.
  auto* view = find<CameraView>("cameraView0");
  QVERIFY(draws(*view));
  const QImage picture = view->grab().toImage();
  const QPoint corner = placeOf({found.x, found.center().y()});
  const QColor expected = targetColor(0);
  bool drawn = false;
  for (int dx = -2; dx <= 2; ++dx) {
    const QColor there = picture.pixelColor(corner + QPoint(dx, 3));
    drawn = drawn || (std::abs(there.red() - expected.red()) < 40 &&
                      std::abs(there.green() - expected.green()) < 40 &&
                      std::abs(there.blue() - expected.blue()) < 40);
  }
  QVERIFY(drawn);
  QVERIFY(find<QLabel>("targetBox")->text().contains(QStringLiteral("Similarity")));
  QVERIFY(find<QLabel>("statusPosition")->text().contains(QStringLiteral("px")));
}

void BoxTest::aDraggedBoxIsAStepThatCanBeUndone() {
  openVideo();
  const ImageBox box = MovingPatch{}.box(0);
  dragTo(placeOf({box.x, box.y}), placeOf({box.x + box.width, box.y + box.height}));
  QVERIFY(waitFor([this] { return !window_->document().project().targets.empty(); }));
  const auto taken = window_->document().project().targets.front().box;
  QVERIFY(taken);
  QVERIFY(intersectionOverUnion(taken->box, box) > 0.8); // a widget pixel is not one of the image
  QCOMPARE(taken->frame, std::int64_t{0});
  QVERIFY(isTrackedTo(kFrames - 1));
  action("actionUndo")->trigger();
  QVERIFY(window_->document().project().targets.empty());
  QVERIFY(waitFor([this] { return window_->shown()->targets.empty(); }));
  action("actionRedo")->trigger();
  QVERIFY(waitFor([this] { return hasBox() && !window_->shown()->rerun; }));
}

void BoxTest::whatIsSavedIsOpenedAgainWithItsBox() {
  openVideo();
  clickAt(MovingPatch{}.box(0).center());
  QVERIFY(isTrackedTo(10));
  action("actionSave")->trigger();
  QVERIFY(waitFor([this] { return !window_->document().isUnsaved(); }));
  const auto targets = window_->document().project().targets;
  window_->openProject(folder_.filePath("one.toml").toStdString());
  QVERIFY(waitFor([this] { return hasBox() && window_->shown()->frame == 0; }));
  QVERIFY(window_->document().project().targets == targets);
}

void BoxTest::lookingBackShowsTheBoxAsItWas() {
  openVideo();
  clickAt(MovingPatch{}.box(0).center());
  QVERIFY(isTrackedTo(20));
  window_->selection().requestFrame(0);
  QVERIFY(waitFor([this] { return window_->shown()->frame == 0 && window_->shown()->isPast; }));
  QVERIFY(hasBox());
  QCOMPARE(first()->box()->box, window_->document().project().targets[0].box->box);
}

void BoxTest::boxesAreExported() {
  openVideo();
  clickAt(MovingPatch{}.box(0).center());
  QVERIFY(isTrackedTo(kFrames - 1));
  auto* dock = find<QDockWidget>("trajectoryDock");
  dock->show();
  dock->raise();
  auto* table = find<QTableView>("boxTable");
  QVERIFY(waitFor([&] { return table->model()->rowCount() == kFrames; }));
  action("actionExportTrajectory")->trigger();
  auto* folder = find<QLineEdit>("boxExportFolder");
  QVERIFY(waitFor([&] { return folder->isVisible(); }));
  const QString out = folder_.filePath("taken home");
  folder->setText(out);
  find<QPushButton>("boxExportExport")->click();
  QVERIFY(waitFor([&] { return messageText().contains(QStringLiteral("boxes.csv")); }));
  const auto csv = readTextFile((out + "/boxes.csv").toStdString());
  QVERIFY(csv);
  QVERIFY(csv->find("target 1") != std::string::npos);
  QVERIFY(readTextFile((out + "/boxes_mot.txt").toStdString()));
  // They are there now: the next press asks, and the one after that replaces them.
  QVERIFY(writeTextFile((out + "/boxes.csv").toStdString(), "precious"));
  auto* question = find<QLabel>("boxExportQuestion");
  auto* start = find<QPushButton>("boxExportExport");
  QVERIFY(waitFor([&] { return start->isEnabled(); }));
  start->click();
  QVERIFY(waitFor([&] { return question->isVisible() && start->isEnabled(); }));
  QCOMPARE(*readTextFile((out + "/boxes.csv").toStdString()), std::string("precious"));
  start->click();
  QVERIFY(waitFor([&] { return !question->isVisible() && start->isEnabled(); }));
  QVERIFY(readTextFile((out + "/boxes.csv").toStdString())->find("target 1") != std::string::npos);
  // Nobody would see the question of a dialog that was closed: it is reported that they are there.
  auto* dialog = find<BoxExportDialog>("boxExportDialog");
  const QSignalSpy failed(dialog, &BoxExportDialog::failed);
  start->click();
  dialog->close();
  QVERIFY(waitFor([&] { return failed.count() == 1 && start->isEnabled(); }));
  QVERIFY(failed[0][0].toString().contains(QStringLiteral("boxes.csv")));
  dialog->show();
  QVERIFY(!question->isVisible());
  QCOMPARE(start->text(), QStringLiteral("Export"));
  // The same when the question would be about another folder by now.
  start->click();
  folder->setText(folder_.filePath("elsewhere"));
  QVERIFY(waitFor([&] { return failed.count() == 2 && start->isEnabled(); }));
  QVERIFY(!question->isVisible());
}

void BoxTest::theMethodIsChosenInTheParameters() {
  window_->openProject({}); // the demo: two calibrated cameras, a color
  QVERIFY(waitFor([this] { return window_->shown() && window_->shown()->frame >= 0; }));
  auto* choice = find<QComboBox>("methodChoice");
  const int row = choice->findData(QStringLiteral("histogram"));
  QVERIFY(row >= 0);
  QVERIFY(choice->findData(QStringLiteral("sugandi")) >= 0);
  choice->setCurrentIndex(row);
  Q_EMIT choice->activated(row);
  QCOMPARE(window_->document().project().method, std::string("histogram"));
  QCOMPARE(messageText(),
           QStringLiteral("Click the object or drag a box around it in any camera view."));
  QVERIFY(waitFor([this] { return window_->shown()->family.targetSource == TargetSource::Box; }));
  QVERIFY(find<QDockWidget>("birdsEyeDock")->isHidden());
  action("actionUndo")->trigger();
  QVERIFY(waitFor([this] { return window_->shown()->family.targetSource != TargetSource::Box; }));
  QVERIFY(!find<QDockWidget>("birdsEyeDock")->isHidden());
}

DEWPOINT_WINDOW_TEST(BoxTest)

} // namespace dewpoint::tests

#include "box_test.moc"
