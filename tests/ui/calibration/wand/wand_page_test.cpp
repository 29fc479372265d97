// SPDX-License-Identifier: GPL-3.0-or-later
// Refining cameras with a waved ball in the real window: the demo's ball as a recording, and as
// live cameras.
#include "core/setup/calibration/wand_refinement.h"
#include "tests/ui/calibration/calibration_window.h"
#include "tests/ui/window_test.h"
#include "ui/selection/selection.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>

namespace dewpoint::tests {
namespace {

/// The frames in which the demo's ball moves well enough: as the test of the command line has them.
constexpr SelectedRange kWave{60, 199};

/// The demo's frames as live cameras would bring them; afterwards nothing comes any more.
class LiveDemo : public FrameSetSource {
public:
  explicit LiveDemo(std::unique_ptr<FrameSetSource> recording) : recording_(std::move(recording)) {}
  std::optional<std::int64_t> frameCount() const override { return std::nullopt; }
  double framesPerSecond() const override { return recording_->framesPerSecond(); }
  Result<FrameSetPtr> next() override {
    std::this_thread::sleep_for(std::chrono::milliseconds(25));
    auto taken = recording_->next();
    if (taken && !*taken) {
      auto nothing = std::make_shared<FrameSet>();
      nothing->frames.resize(2);
      return nothing;
    }
    return taken;
  }
  Status seek(std::int64_t) override { return {}; }

private:
  std::unique_ptr<FrameSetSource> recording_;
};

} // namespace

class WandPageTest : public QObject, private test::CalibrationWindow {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup();
  void refinesInOneStepAsTheCommandLineDoes();
  void cancelKeepsTheCameras();
  void aBadResultIsOneSentence();
  void touchedInstantsAreAddedAndRemoved();
  void saysWhatIsMissing();
  void liveCamerasAreCollected();
  void everythingHasAName();

private:
  void press(const char* name) { QTest::mouseClick(find<QPushButton>(name), Qt::LeftButton); }
  void refine(const SelectedRange& selectedRange);
  CameraRig cameras() {
    CameraRig rig;
    for (const ProjectCamera& one : project().cameras) {
      rig.push_back(one.camera);
    }
    return rig;
  }
  bool isIdle() { return !find<QProgressBar>("wandProgress")->isVisible(); }
};

void WandPageTest::init() {
  openCalibration();
  find<QAction>("actionCalibrateWand")->trigger();
  QVERIFY(find<QWidget>("wandPage")->isVisible());
}

void WandPageTest::cleanup() {
  window_.reset();
}

void WandPageTest::refine(const SelectedRange& selectedRange) {
  window_->selection().selectRange(selectedRange);
  find<QCheckBox>("wandSpan")->click();
  QVERIFY(find<QCheckBox>("wandSpan")->isChecked());
  find<QComboBox>("wandSize")->activated(0);
  press("wandRefine");
  QVERIFY(!isIdle());
}

void WandPageTest::refinesInOneStepAsTheCommandLineDoes() {
  // Roughly nudged: 3 cm off.
  QVERIFY(window_->document().edit(QStringLiteral("nudge"), [](Project& project) {
    project.cameras[0].hasOwnCalibration = true;
    project.cameras[0].camera.cameraFromWorld.translation() += Eigen::Vector3d(0.03, 0.0, 0.0);
  }));
  const CameraRig before = cameras();
  const Project nudged = project();
  refine(kWave);
  QVERIFY(waitFor([&] { return isIdle(); }));
  auto inputs = openProject(SessionRequest(nudged));
  QVERIFY(inputs);
  WandOptions options; // as "dewpoint-cli calibrate wand demo --frames 60:200"
  options.firstFrame = 60;
  options.endFrame = 200;
  const auto expected = refineFromRecording(inputs->project, *inputs->source, options);
  QVERIFY(expected);
  if (isDoubtful(*expected)) {
    press("wandApply");
  }
  QVERIFY(cameras() == expected->result.cameras); // to the bit
  QVERIFY(cameras() != before);
  QCOMPARE(history().count(), 2);
  QVERIFY(history().undoText().contains(QStringLiteral("Refine cameras")));
  const QString verdict = find<QLabel>("wandAssessment")->text();
  QVERIFY2(verdict.contains(QStringLiteral("In the calibrated volume: position ±")),
           qPrintable(verdict));
  auto* table = find<QTableWidget>("wandCameras");
  QCOMPARE(table->rowCount(), 2);
  QVERIFY(table->item(0, 1)->text().toDouble() > 0.0);
  QVERIFY(table->item(0, 1)->text().toDouble() < 1.0); // px: rendered images
  // While it is pressed, the views show the grid with the cameras as they were.
  QVERIFY(draws(*layer(0)->parentWidget())); // else they differ by the image that comes
  const QImage after = layer(0)->parentWidget()->grab().toImage();
  QTest::mousePress(find<QPushButton>("wandFlip"), Qt::LeftButton);
  QVERIFY(layer(0)->parentWidget()->grab().toImage() != after);
  QTest::mouseRelease(find<QPushButton>("wandFlip"), Qt::LeftButton);
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(cameras() == before);
  QTest::keyClick(window_.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  QVERIFY(cameras() == expected->result.cameras);
}

void WandPageTest::cancelKeepsTheCameras() {
  const CameraRig before = cameras();
  refine({0, 377});
  press("wandCancel");
  QVERIFY(waitFor([&] { return isIdle(); }));
  QVERIFY(cameras() == before);
  QCOMPARE(history().count(), 0);
  QVERIFY(!find<QLabel>("wandAssessment")->isVisible());
  QVERIFY(find<QPushButton>("wandRefine")->isEnabled());
}

void WandPageTest::aBadResultIsOneSentence() {
  const CameraRig before = cameras();
  refine({0, 29}); // the ball is at rest there
  QVERIFY(waitFor([&] { return isIdle(); }));
  QVERIFY(find<QLabel>("wandAssessment")->isVisible());
  QVERIFY(find<QLabel>("wandAssessment")->text().startsWith(QStringLiteral("⚠")));
  QVERIFY(find<QLabel>("wandNotes")->text().contains(QStringLiteral("unchanged")));
  QVERIFY(!find<QTableWidget>("wandCameras")->isVisible());
  QVERIFY(cameras() == before);
  QCOMPARE(history().count(), 0);
  QVERIFY(QApplication::activeModalWidget() == nullptr);
}

void WandPageTest::touchedInstantsAreAddedAndRemoved() {
  auto* list = find<QListWidget>("wandMomentList");
  press("wandTake");
  QCOMPARE(list->count(), 1);
  press("wandTake"); // the same again is one
  QCOMPARE(list->count(), 1);
  const qint64 first = window_->shown()->frame;
  QTest::keyClick(window_.get(), Qt::Key_Period);
  QVERIFY(waitFor([&] { return window_->shown()->frame > first; }));
  press("wandTake");
  QCOMPARE(list->count(), 2); // the floor is touched at several places
  find<QComboBox>("wandRole")->setCurrentIndex(3);
  press("wandTake");
  QCOMPARE(list->count(), 3);
  QVERIFY(find<QLabel>("wandMissing")->text().contains(QStringLiteral("fall")));
  QVERIFY(!find<QPushButton>("wandRefine")->isEnabled());
  list->setCurrentRow(2);
  press("wandRemove");
  QCOMPARE(list->count(), 2);
  QVERIFY(find<QPushButton>("wandRefine")->isEnabled());
  // Enter shows the moment again.
  list->setCurrentRow(0);
  list->itemActivated(list->item(0));
  QVERIFY(waitFor([&] { return window_->shown()->frame == first; }));
}

void WandPageTest::saysWhatIsMissing() {
  auto* missing = find<QLabel>("wandMissing");
  QVERIFY(!missing->isVisible());
  QVERIFY(!find<QComboBox>("wandOther")->isVisible());
  find<QComboBox>("wandKind")->activated(1); // a stick, but the demo has one ball
  QVERIFY(missing->isVisible());
  QVERIFY(find<QComboBox>("wandOther")->isVisible());
  QVERIFY(!find<QPushButton>("wandRefine")->isEnabled());
  QVERIFY(window_->document().edit(QStringLiteral("another"), [](Project& project) {
    project.targets.push_back(project.targets.front());
    project.targets.back().name = "another";
  }));
  QVERIFY(!missing->isVisible());
  QCOMPARE(find<QComboBox>("wandOther")->currentText(), QStringLiteral("another"));
  find<QComboBox>("wandOther")->setCurrentIndex(0);
  find<QComboBox>("wandOther")->activated(0);
  QVERIFY(missing->isVisible()); // both ends are one
  find<QComboBox>("wandKind")->activated(0);
  find<QComboBox>("wandSize")->activated(2); // a distance, but no moments
  QVERIFY(missing->isVisible());
  QVERIFY(find<QWidget>("wandDistance")->isVisible());
}

void WandPageTest::liveCamerasAreCollected() {
  const auto openLive = [](const SessionRequest& request) {
    auto inputs = openProject(request);
    if (inputs) {
      inputs->source = std::make_unique<LiveDemo>(std::move(inputs->source));
    }
    return inputs;
  };
  makeAnotherWindow({.opener = openLive, .size = {1500, 950}, .play = false});
  open();
  find<QAction>("actionCalibrateWand")->trigger();
  QVERIFY(waitFor([&] { return find<QWidget>("wandWave")->isVisible(); }));
  QVERIFY(!find<QPushButton>("wandRefine")->isEnabled());
  QVERIFY(find<QLabel>("wandMissing")->text().contains(QStringLiteral("Start waving")));
  const CameraRig before = cameras();
  press("wandWave");
  QVERIFY(waitFor([&] {
    const auto* seen = window_->findChild<QLabel*>(QStringLiteral("wandSeen1"));
    return seen != nullptr && seen->text().section(QLatin1Char(' '), -1).toInt() > 230;
  }));
  QVERIFY(find<QWidget>("wandMap0")->accessibleName().contains(QStringLiteral("regions")));
  press("wandWave"); // stop
  QVERIFY(find<QPushButton>("wandWave")->text().contains(QStringLiteral("Start")));
  find<QComboBox>("wandSize")->activated(0);
  press("wandRefine");
  QVERIFY(waitFor([&] { return isIdle(); }));
  const QString verdict = find<QLabel>("wandAssessment")->text();
  QVERIFY2(verdict.contains(QStringLiteral("In the calibrated volume: position ±")),
           qPrintable(verdict));
  if (find<QPushButton>("wandApply")->isVisible()) {
    press("wandApply");
  }
  QVERIFY(cameras() != before);
  QCOMPARE(history().count(), 1);
  // The demo's cameras are the true ones: they stay near (two cameras and a short path).
  for (std::size_t k = 0; k < 2; ++k) {
    QVERIFY((cameras()[k].center() - before[k].center()).norm() < 0.1);
  }
}

void WandPageTest::everythingHasAName() {
  for (QWidget* field : find<QWidget>("wandPage")->findChildren<QWidget*>()) {
    const bool control = qobject_cast<QAbstractButton*>(field) != nullptr ||
                         qobject_cast<QComboBox*>(field) != nullptr ||
                         qobject_cast<QAbstractSpinBox*>(field) != nullptr ||
                         qobject_cast<QListWidget*>(field) != nullptr;
    if (control && qobject_cast<QTableWidget*>(field->parentWidget()) == nullptr &&
        field->parentWidget()->objectName().startsWith(QStringLiteral("wand"))) {
      QVERIFY2(!field->accessibleName().isEmpty(), qPrintable(field->objectName()));
      QVERIFY2(!field->toolTip().isEmpty(), qPrintable(field->objectName()));
      QVERIFY2(!field->objectName().isEmpty(), qPrintable(field->accessibleName()));
    }
  }
}

DEWPOINT_WINDOW_TEST(WandPageTest)

} // namespace dewpoint::tests

#include "wand_page_test.moc"
