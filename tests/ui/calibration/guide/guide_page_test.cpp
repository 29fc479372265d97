// SPDX-License-Identifier: GPL-3.0-or-later
// The guide of the calibration panel in the real window: what is known, a way, its steps.
#include "core/setup/calibration/calibration_guide.h"
#include "core/setup/new_project/new_project.h"
#include "tests/ui/calibration/calibration_window.h"
#include "tests/ui/mainwindow/small_picture.h"
#include "tests/ui/window_test.h"
#include "ui/calibration/calibration_dock.h"
#include "ui/document/document.h"
#include "ui/widgets/message_bar.h"

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QTableWidget>
#include <QToolButton>

namespace dewpoint::tests {

class GuidePageTest : public QObject, private test::CalibrationWindow {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup() { window_.reset(); }
  void showsWhatIsKnown();
  void leadsThroughTheStepsOfAWay();
  void aStepOpensItsPage();
  void followsTheProject();
  void theStripWaitsUntilTheGuideIsSeen();
  void asksWhilePositionsAreGuesses();

private:
  /// The picture of the manual, into the folder that DEWPOINT_MANUAL names (docs/images).
  void keepPicture();
  CalibrationDock* pages() { return find<CalibrationDock>("calibrationPlace"); }
  QTableWidget* known() { return find<QTableWidget>("guideKnown"); }
  QString text(const char* label) { return find<QLabel>(label)->text(); }
  void press(const char* button) { QTest::mouseClick(find<QPushButton>(button), Qt::LeftButton); }
  /// Chooses a way by its radio button.
  void choose(CalibrationProcedure way) {
    const QString name = QStringLiteral("guideWay%1").arg(static_cast<int>(way));
    find<QRadioButton>(name)->click();
  }
};

void GuidePageTest::init() {
  openCalibration();
  find<QAction>("actionCalibrate")->trigger();
  QCOMPARE(pages()->shownPage(), QStringLiteral("guidePage"));
}

void GuidePageTest::showsWhatIsKnown() {
  QCOMPARE(known()->rowCount(), 2);
  QVERIFY(known()->item(0, 1)->text().startsWith(QStringLiteral("✓"))); // simulated
  QVERIFY(!find<QWidget>("guideStrip")->isVisible());
  QVERIFY(!find<QPushButton>("guideNext")->isVisible());
}

void GuidePageTest::leadsThroughTheStepsOfAWay() {
  choose(CalibrationProcedure::Board);
  QVERIFY(find<QWidget>("guideStrip")->isVisible());
  QVERIFY(find<QPushButton>("guideNext")->isVisible());
  while (find<QPushButton>("guideBack")->isEnabled()) {
    press("guideBack");
  }
  QStringList titles;
  for (titles << text("guideStepTitle"); find<QPushButton>("guideNext")->isEnabled();
       titles << text("guideStepTitle")) {
    press("guideNext");
    QVERIFY(!text("guideHow").isEmpty());
    QVERIFY(!text("guideReached").isEmpty());
  }
  QCOMPARE(titles.size(), static_cast<qsizetype>(stepsOf(CalibrationProcedure::Board).size()));
  QCOMPARE(titles.removeDuplicates(), 0);
  find<QToolButton>("guideStep4")->click();
  find<QAction>("actionCalibrate")->trigger();
  keepPicture();
  QVERIFY(!find<QRadioButton>("guideWay0")->isVisible());
  press("guideOther");
  QVERIFY(find<QRadioButton>("guideWay0")->isVisible());
  QVERIFY(!find<QPushButton>("guideNext")->isVisible());
  choose(CalibrationProcedure::File);
  QVERIFY(!find<QRadioButton>("guideWay0")->isVisible());
}

void GuidePageTest::aStepOpensItsPage() {
  choose(CalibrationProcedure::Board);
  find<QToolButton>("guideStep1")->click();
  QCOMPARE(pages()->shownPage(), QStringLiteral("boardPage"));
  QVERIFY(find<QWidget>("guideStrip")->isVisible()); // it stays
  find<QToolButton>("guideStep3")->click();
  QCOMPARE(pages()->shownPage(), QStringLiteral("worldPage"));
  QVERIFY(find<QToolButton>("guideStep3")->isChecked());
  find<QAction>("actionCalibrate")->trigger();
  QCOMPARE(pages()->shownPage(), QStringLiteral("guidePage"));
  choose(CalibrationProcedure::Wand);
  QVERIFY(find<QToolButton>("guideStep5") != nullptr);
  find<QToolButton>("guideStep3")->click();
  QCOMPARE(pages()->shownPage(), QStringLiteral("wandPage"));
}

void GuidePageTest::followsTheProject() {
  choose(CalibrationProcedure::Grid);
  QVERIFY(window_->document().edit(QStringLiteral("move"), [](Project& project) {
    project.cameras[0].camera.cameraFromWorld.translation().x() += 0.01;
    project.cameras[0].markCalibrationChanged();
  }));
  QVERIFY(known()->item(0, 2)->text().startsWith(QStringLiteral("○"))); // nobody measured it
  QVERIFY(known()->item(1, 2)->text().startsWith(QStringLiteral("✓")));
  find<QAction>("actionUndo")->trigger();
  QVERIFY(known()->item(0, 2)->text().startsWith(QStringLiteral("✓")));
}

void GuidePageTest::theStripWaitsUntilTheGuideIsSeen() {
  find<QAction>("actionCalibrateByHand")->trigger();
  QCOMPARE(pages()->shownPage(), QStringLiteral("handPage"));
  QVERIFY(window_->document().edit(QStringLiteral("compute"), [](Project& project) {
    for (ProjectCamera& one : project.cameras) {
      one.camera.cameraFromWorld.translation().x() += 0.01;
      one.markCalibrationChanged();
      one.calibrationRecord.pose = recordOfPose(one.camera, CalibrationOrigin::Points, 0.001);
    }
  }));
  QVERIFY(!find<QWidget>("guideStrip")->isVisible()); // the page stays where it is
  find<QAction>("actionCalibrate")->trigger();
  QVERIFY(find<QWidget>("guideStrip")->isVisible()); // the guide knows the way
  find<QAction>("actionCalibrateByHand")->trigger();
  QVERIFY(find<QWidget>("guideStrip")->isVisible());
}

void GuidePageTest::keepPicture() {
  const QString folder = qEnvironmentVariable("DEWPOINT_MANUAL");
  if (folder.isEmpty()) {
    return;
  }
  QVERIFY(settles(*window_));
  const QString file = folder + QStringLiteral("/calibration-guide.png");
  QVERIFY2(withFewerLevels(window_->grab().toImage()).save(file), qPrintable(file));
}

void GuidePageTest::asksWhilePositionsAreGuesses() {
  auto* messages = window_->findChild<MessageBar*>();
  QVERIFY(messages != nullptr);
  Project calibrated = project();
  Project guessed = calibrated;
  for (std::size_t k = 0; k < guessed.cameras.size(); ++k) {
    const Intrinsics& image = guessed.cameras[k].camera.intrinsics;
    guessCalibration(guessed, k, {image.width, image.height});
    guessed.cameras[k].markCalibrationChanged();
  }
  QVERIFY(window_->document().edit(QStringLiteral("guess"),
                                   [&](Project& project) { project = guessed; }));
  QVERIFY(known()->item(0, 1)->text().startsWith(QStringLiteral("⚠")));
  QVERIFY(known()->item(0, 2)->text().startsWith(QStringLiteral("⚠")));
  window_->document().setMethod("barrera");
  QVERIFY(messages->isVisible());
  const QString question = messages->text();
  messages->showNotice(QStringLiteral("something else"));
  messages->dismiss();
  QCOMPARE(messages->text(), question); // it is asked again
  QVERIFY(window_->document().edit(QStringLiteral("calibrate"), [&](Project& project) {
    project.cameras = calibrated.cameras;
  }));
  QVERIFY(messages->text() != question);
  find<QAction>("actionUndo")->trigger(); // guesses again
  QCOMPARE(messages->text(), question);
  messages->dismiss();
  QVERIFY(window_->document().edit(QStringLiteral("move"), [](Project& project) {
    project.cameras[0].camera.cameraFromWorld.translation().x() += 0.1;
  }));
  QVERIFY(messages->text() != question); // the user has closed it, and another camera is a guess
}

DEWPOINT_WINDOW_TEST(GuidePageTest)

} // namespace dewpoint::tests

#include "guide_page_test.moc"
