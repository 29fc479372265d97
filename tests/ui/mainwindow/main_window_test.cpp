// SPDX-License-Identifier: GPL-3.0-or-later
// The real window with the built-in demo, driven by actions, mouse and keyboard as a person would.
#include "core/session/session.h"
#include "core/session/snapshot/snapshot.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/cameraview/camera_view.h"
#include "ui/document/document.h"
#include "ui/plots/plot_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QSignalSpy>
#include <QSlider>
#include <QStatusBar>
#include <QToolButton>

#include <optional>

namespace dewpoint::tests {

class MainWindowTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void init();
  void cleanup();
  void playsTheDemoAndHolds();
  void playAndPauseByMouseAndKey();
  void nextFrameByMouse();
  void oneIterationByMouse();
  void sliderActsAndUndoReturns();
  void maskChangesPixels();
  void statusBarSaysWhatTheSnapshotSays();
  void restartWithTheSameSeedRepeats();
  void restartWithANewSeedDiffers();
  void everyThemePaintsItsOwnGround();
  void failedOpeningIsASentenceNotACrash();
  void thePaletteMatchesWordsInAnyOrder();
  void everyActionHasATooltip();
  void noQt5InTheProcess();

private:
  void click(const char* name) { QTest::mouseClick(find<QToolButton>(name), Qt::LeftButton); }
  QString label(const char* name) { return find<QLabel>(name)->text(); }
  void openDemo(bool play);
  bool pauseNow();
  /// Restarts (paused) and tracks `frames` frames one by one; the mean after the last, or nothing
  /// if that never happens.
  std::optional<Eigen::Vector3d> meanAfterFrames(const char* restart, int frames);
};

void MainWindowTest::init() {
  makeWindow({.theme = Theme::Light});
}

void MainWindowTest::cleanup() {
  window_.reset();
}

void MainWindowTest::openDemo(bool play) {
  window_->setPlayOnOpen(play);
  open();
  // The first snapshot shows the first frame untracked.
  QVERIFY(waitFor([this] { return shown().frame >= 0 && shown().iterationCount > 0; }));
}

bool MainWindowTest::pauseNow() {
  if (shown().state == PlayState::Playing) {
    click("actionPlayButton");
  }
  return waitFor([this] { return shown().state != PlayState::Playing; });
}

std::optional<Eigen::Vector3d> MainWindowTest::meanAfterFrames(const char* restart, int frames) {
  find<QAction>(restart)->trigger();
  // A restart shows the first frame untracked; the first "next frame" tracks it.
  if (!waitFor([this] { return shown().frame == 0 && shown().iterationCount == 0; })) {
    return std::nullopt;
  }
  for (int frame = 0; frame < frames; ++frame) {
    const qint64 iterations = shown().iterationCount;
    click("actionNextFrameButton");
    if (!waitFor([&] { return shown().frame == frame && shown().iterationCount > iterations; })) {
      return std::nullopt;
    }
  }
  return std::get<SphereEstimate>(shown().targets.front().estimate).mean;
}

void MainWindowTest::playsTheDemoAndHolds() {
  openDemo(true);
  // The demo's ball is found within 60 iterations (Barrera's own count per still frame).
  QVERIFY(waitFor([this] {
    return shown().frame >= 20 &&
           std::get<SphereEstimate>(shown().targets.front().estimate).isValid;
  }));
  QCOMPARE(shown().rig->size(), std::size_t{2}); // the demo: Barrera's two cameras
  QVERIFY(label("cameraDock0TitleState").contains(QStringLiteral("tracking")));
  QVERIFY(find<PlotPanel>("plotPanel")->shownIterationCount() > 0);
}

void MainWindowTest::playAndPauseByMouseAndKey() {
  openDemo(true);
  QVERIFY(waitFor([this] { return shown().state == PlayState::Playing; }));
  QCOMPARE(find<QAction>("actionPlay")->text(), QStringLiteral("Pause"));
  QVERIFY(pauseNow());
  QCOMPARE(find<QAction>("actionPlay")->text(), QStringLiteral("Play"));
  const qint64 frame = shown().frame;
  letTimePass();
  QCOMPARE(shown().frame, frame); // paused means no more frames
  QTest::keyClick(window_.get(), Qt::Key_Space);
  QVERIFY(waitFor([&] { return shown().frame > frame; }));
}

void MainWindowTest::nextFrameByMouse() {
  openDemo(false);
  const qint64 frame = shown().frame;
  click("actionNextFrameButton");
  QVERIFY(waitFor([&] { return shown().frame == frame + 1; }));
  QTest::keyClick(window_.get(), Qt::Key_Period);
  QVERIFY(waitFor([&] { return shown().frame == frame + 2; }));
  letTimePass(200);
  QCOMPARE(shown().frame, frame + 2); // and not one more
  QVERIFY(shown().state == PlayState::Paused);
}

void MainWindowTest::oneIterationByMouse() {
  openDemo(false);
  const qint64 frame = shown().frame;
  const qint64 iterations = shown().iterationCount;
  click("actionNextIterationButton");
  QVERIFY(waitFor([&] { return shown().iterationCount == iterations + 1; }));
  QCOMPARE(shown().frame, frame);
  find<QAction>("actionNextIteration")->trigger();
  QVERIFY(waitFor([&] { return shown().iterationCount == iterations + 2; }));
  QCOMPARE(shown().frame, frame);
}

void MainWindowTest::sliderActsAndUndoReturns() {
  openDemo(false);
  // Method barrera uses all its particles always.
  auto* choice = find<QComboBox>("methodChoice");
  QCOMPARE(choice->currentData().toString(), QStringLiteral("dewpoint"));
  choice->setCurrentIndex(choice->findData(QStringLiteral("barrera")) - 1); // the heading above it
  choice->setFocus();
  QTest::keyClick(choice, Qt::Key_Down);
  QCOMPARE(window_->document().project().method, std::string("barrera"));
  QVERIFY(waitFor([&] { return window_->findChild<QSlider*>("slider_motion_sigma") != nullptr; }));
  const auto declarations = window_->document().project().parameters.declarations();
  QVERIFY(!declarations.empty());
  const std::string key = "particles";
  const double before = window_->document().project().parameters.at(key);
  auto* slider = find<QSlider>("slider_particles");
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_PageUp);
  QTest::keyClick(slider, Qt::Key_PageUp); // merges with the first
  const double after = window_->document().project().parameters.at(key);
  QVERIFY(after > before);
  QCOMPARE(find<QDoubleSpinBox>("box_particles")->value(), after);
  click("actionNextFrameButton");
  QVERIFY(waitFor([&] {
    return std::get<SphereEstimate>(shown().targets.front().estimate).particleCount ==
           static_cast<int>(after);
  }));
  click("actionUndoButton");
  QCOMPARE(window_->document().project().parameters.at(key), before);
  QCOMPARE(find<QDoubleSpinBox>("box_particles")->value(), before);
  click("actionUndoButton");
  QCOMPARE(window_->document().project().method, std::string("dewpoint"));
  QVERIFY(waitFor([&] { return window_->findChild<QSlider*>("slider_motion_sigma") == nullptr; }));
  QCOMPARE(find<QComboBox>("methodChoice")->currentData().toString(), QStringLiteral("dewpoint"));
  QVERIFY(!window_->isWindowModified());
}

void MainWindowTest::maskChangesPixels() {
  openDemo(false);
  auto* view = find<CameraView>("cameraView0");
  QVERIFY(draws(*view));
  const QImage without = view->grab().toImage();
  click("actionShowMaskButton");
  QVERIFY(waitFor([this] { return !shown().masks.empty(); }));
  QVERIFY(draws(*view));
  const QImage with = view->grab().toImage();
  QVERIFY(with != without);
  click("actionShowMaskButton");
  QVERIFY(waitFor([&] { return view->grab().toImage() == without; }));
}

void MainWindowTest::statusBarSaysWhatTheSnapshotSays() {
  openDemo(true);
  QVERIFY(waitFor([this] { return shown().frame >= 3; }));
  QVERIFY(pauseNow());
  const auto estimate = std::get<SphereEstimate>(shown().targets.front().estimate);
  QVERIFY(shown().frameCount.has_value());
  QCOMPARE(label("statusFrame"),
           QStringLiteral("frame %1 / %2").arg(shown().frame + 1).arg(*shown().frameCount));
  QVERIFY(label("statusSampleSize").contains(QString::number(estimate.particleCount)));
  const QString time = label("statusTime"); // milliseconds on a slow machine
  QVERIFY2(time.contains(QStringLiteral("µs")) || time.contains(QStringLiteral("ms")),
           qPrintable(time));
  QVERIFY(label("statusSpread").contains(QStringLiteral("±")));
  QVERIFY(label("statusSpeed").contains(QStringLiteral("m/s")));
  QCOMPARE(label("statusPlaying"), QStringLiteral("paused"));
  QCOMPARE(label("statusHeld").contains(QStringLiteral("● tracking")), estimate.isValid);
}

void MainWindowTest::restartWithTheSameSeedRepeats() {
  openDemo(false);
  const auto first = meanAfterFrames("actionRestart", 5);
  const auto seed = shown().seed;
  const auto second = meanAfterFrames("actionRestart", 5);
  QCOMPARE(shown().seed, seed);
  QVERIFY(first && second);
  QVERIFY(*first == *second); // the same bits, not nearly
}

void MainWindowTest::restartWithANewSeedDiffers() {
  openDemo(false);
  const auto first = meanAfterFrames("actionRestart", 5);
  const auto seed = shown().seed;
  const auto second = meanAfterFrames("actionRestartNewSeed", 5);
  QVERIFY(shown().seed != seed);
  QVERIFY(first && second);
  QVERIFY(*first != *second);
}

void MainWindowTest::everyThemePaintsItsOwnGround() {
  // A corner of the status bar: nothing but the theme is painted there, at any scale.
  const auto ground = [this] { return window_->statusBar()->grab().toImage().pixelColor(2, 2); };
  find<QAction>("actionThemeDark")->trigger();
  QVERIFY(waitFor([&] { return ground().lightness() < 100; }));
  find<QAction>("actionThemeLight")->trigger();
  QVERIFY(waitFor([&] { return ground().lightness() > 150; }));
}

void MainWindowTest::failedOpeningIsASentenceNotACrash() {
  QSignalSpy failed(window_.get(), &MainWindow::openFailed);
  window_->openProject("no-such-project.toml");
  QVERIFY(failed.wait(kTimeoutMs));
  QVERIFY(find<QLabel>("messageText")->isVisible());
  QVERIFY(label("messageText").contains(QStringLiteral("no-such-project.toml")));
  click("messageClose");
  QVERIFY(!find<QLabel>("messageText")->isVisible());
}

void MainWindowTest::thePaletteMatchesWordsInAnyOrder() {
  openDemo(false);
  QTest::keyClick(window_.get(), Qt::Key_K, Qt::ControlModifier);
  auto* search = find<QLineEdit>("paletteSearch");
  auto* list = find<QListWidget>("paletteList");
  QVERIFY(waitFor([&] { return search->isVisible(); }));
  // Nothing is chosen, and nothing run, before something is typed or gone to.
  QVERIFY(list->count() > 20);
  QCOMPARE(list->currentRow(), -1);
  QTest::keyClick(search, Qt::Key_Return);
  QVERIFY(search->isVisible());
  QTest::keyClick(search, Qt::Key_Down);
  QCOMPARE(list->currentRow(), 0);
  for (const char* words : {"views history", "history views", "Views › History"}) {
    search->setText(QString::fromUtf8(words));
    QVERIFY2(list->item(0)->text().startsWith(QStringLiteral("Views › History")), words);
  }
  // Only what has a word with these letters, those first whose name begins so.
  search->setText(QStringLiteral("hist"));
  QVERIFY(list->item(0)->text().contains(QStringLiteral("› Hist")));
  for (int row = 0; row < list->count(); ++row) {
    QVERIFY2((list->item(row)->text() + list->item(row)->toolTip())
                 .contains(QStringLiteral("hist"), Qt::CaseInsensitive),
             qPrintable(list->item(row)->text()));
  }
  search->setText(QStringLiteral("shwmsk")); // no word: its letters do
  QVERIFY(list->item(0)->text().contains(QStringLiteral("Show mask")));
}

void MainWindowTest::everyActionHasATooltip() {
  for (const QAction* action : window_->findChildren<QAction*>()) {
    if (action->objectName().startsWith(QStringLiteral("action"))) {
      QVERIFY2(!action->toolTip().isEmpty(), qPrintable(action->objectName()));
    }
  }
}

void MainWindowTest::noQt5InTheProcess() {
  QFile maps(QStringLiteral("/proc/self/maps"));
  QVERIFY(maps.open(QIODevice::ReadOnly));
  QVERIFY(!maps.readAll().contains("libQt5"));
}

DEWPOINT_WINDOW_TEST(MainWindowTest)

} // namespace dewpoint::tests

#include "main_window_test.moc"
