// SPDX-License-Identifier: GPL-3.0-or-later
// The guide of the calibration panel in the real window: what is known, a way, its steps.
#include "core/setup/calibration/calibration_guide.h"
#include "tests/ui/calibration/calibration_window.h"
#include "tests/ui/mainwindow/small_picture.h"
#include "tests/ui/window_test.h"
#include "ui/calibration/calibration_dock.h"
#include "ui/document/document.h"

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

private:
  CalibrationDock* pages() { return find<CalibrationDock>("calibrationPlace"); }
  QTableWidget* known() { return find<QTableWidget>("guideKnown"); }
  QString text(const char* label) { return find<QLabel>(label)->text(); }
  void press(const char* button) { QTest::mouseClick(find<QPushButton>(button), Qt::LeftButton); }
  /// Chooses a way by its radio button.
  void choose(CalibrationWay way) {
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
  choose(CalibrationWay::Board);
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
  QCOMPARE(titles.size(), static_cast<qsizetype>(stepsOf(CalibrationWay::Board).size()));
  QCOMPARE(titles.removeDuplicates(), 0);
}

void GuidePageTest::aStepOpensItsPage() {
  choose(CalibrationWay::Board);
  find<QToolButton>("guideStep1")->click();
  QCOMPARE(pages()->shownPage(), QStringLiteral("boardPage"));
  QVERIFY(find<QWidget>("guideStrip")->isVisible()); // it stays
  find<QToolButton>("guideStep3")->click();
  QCOMPARE(pages()->shownPage(), QStringLiteral("worldPage"));
  QVERIFY(find<QToolButton>("guideStep3")->isChecked());
  find<QAction>("actionCalibrate")->trigger();
  QCOMPARE(pages()->shownPage(), QStringLiteral("guidePage"));
  choose(CalibrationWay::Wand);
  QVERIFY(find<QToolButton>("guideStep5") != nullptr);
  find<QToolButton>("guideStep3")->click();
  QCOMPARE(pages()->shownPage(), QStringLiteral("wandPage"));
}

void GuidePageTest::followsTheProject() {
  choose(CalibrationWay::Grid);
  QVERIFY(window_->document().edit(QStringLiteral("move"), [](Project& project) {
    project.cameras[0].camera.cameraFromWorld.translation().x() += 0.01;
    project.cameras[0].markAdjusted();
  }));
  QVERIFY(known()->item(0, 2)->text().startsWith(QStringLiteral("○"))); // nobody measured it
  QVERIFY(known()->item(1, 2)->text().startsWith(QStringLiteral("✓")));
  find<QAction>("actionUndo")->trigger();
  QVERIFY(known()->item(0, 2)->text().startsWith(QStringLiteral("✓")));
}

DEWPOINT_WINDOW_TEST(GuidePageTest)

} // namespace dewpoint::tests

#include "guide_page_test.moc"
