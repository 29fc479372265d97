// SPDX-License-Identifier: GPL-3.0-or-later
// Calibrating with a board in the real window: a recording, and live cameras.
#include "core/session/snapshot/snapshot.h"
#include "core/setup/calibration/board_outcome.h"
#include "tests/ui/calibration/board/board_page_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/calibration/board/board_calibrator.h"
#include "ui/calibration/board/board_map.h"
#include "ui/calibration/board/board_text.h"
#include "ui/document/document.h"
#include "ui/text/language.h"
#include "ui/widgets/message_bar.h"

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QScopeGuard>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QUndoStack>

#include <memory>
#include <utility>

namespace dewpoint::tests {

class BoardPageTest : public QObject, private test::BoardPageFixture {
  Q_OBJECT

private Q_SLOTS:
  void initTestCase() { record(); }
  void init() { QSettings().clear(); }
  void cleanup() { window_.reset(); }
  void aRecordingCalibratesInOneStep();
  void framesWithoutTheBoardAreNamed();
  void theFloorFrameCountsFromOne();
  void theCommandLineGivesTheSameBits();
  void cancelKeepsWhatWas();
  void theShownBoardSetsTheFloor();
  void printsAndReports();
  void theBoardIsRemembered();
  void liveCamerasAreGuidedToTheEnd();
  void liveViewsCanBeTakenByHand();
  void theNextViewIsShownAcrossTheRoom();
  void everythingHasAName();
  void theSearchIsKnownInAnotherLanguage();

private:
  /// A picture of the window in both themes, as the manual shows it: into the folder that
  /// DEWPOINT_SCREENSHOTS names, or beside the test.
  void keep(const QString& name);
};

void BoardPageTest::keep(const QString& name) {
  const QString folder =
      qEnvironmentVariable("DEWPOINT_SCREENSHOTS", QStringLiteral("screenshots"));
  QVERIFY(QDir().mkpath(folder));
  for (const auto& [theme, suffix] :
       {std::pair(Theme::Dark, "-dark.png"), std::pair(Theme::Light, ".png")}) {
    window_->setTheme(theme);
    QVERIFY(draws(*window_));
    QVERIFY(window_->grab().save(folder + QLatin1Char('/') + name + QLatin1String(suffix)));
  }
}

void BoardPageTest::aRecordingCalibratesInOneStep() {
  openRecording();
  const auto before = project().cameras;
  const QSignalSpy progress(&calibrator(), &BoardCalibrator::progressChanged);
  QVERIFY(calibrate());
  // The board is looked for first, and how far that is, is known; nobody looks for it afterwards.
  QVERIFY(!progress.isEmpty() && progress.first().first().toDouble() >= 0.0);
  QVERIFY(!calibrator().isSearchingRecording());
  QVERIFY2(calibrator().isApplied(), qPrintable(result()));
  QCOMPARE(history().count(), 1);
  QVERIFY(!history().undoText().isEmpty());
  for (std::size_t k = 0; k < 2; ++k) {
    const double focal = project().cameras[k].camera.intrinsics.focalX;
    QVERIFY2(std::abs(focal - shown_.cameras[k].intrinsics.focalX) < 4.0, qPrintable(result()));
  }
  const double apart =
      (project().cameras[0].camera.center() - project().cameras[1].camera.center()).norm();
  QVERIFY(std::abs(apart - 0.1) < 0.002); // as the cameras of the scene stand
  for (const char* part : {"left", "right", "RMS", "95 %"}) {
    QVERIFY2(result().contains(QLatin1String(part)), qPrintable(result()));
  }
  scrollTo(find<QPushButton>(QStringLiteral("boardReport")));
  keep(QStringLiteral("calibration-board"));
  const auto after = project().cameras;
  history().undo();
  QVERIFY(project().cameras == before);
  QVERIFY(find<QPushButton>(QStringLiteral("boardApply"))->isVisible());
  history().redo();
  QVERIFY(project().cameras == after);
  QVERIFY(!find<QPushButton>(QStringLiteral("boardApply"))->isVisible());
}

void BoardPageTest::framesWithoutTheBoardAreNamed() {
  openRecording();
  QVERIFY(calibrate());
  BoardOutcome outcome = *calibrator().outcome();
  BoardMiss small;
  small.reason = BoardMiss::Reason::TooSmall;
  small.squareSizePx = 6.2;
  outcome.missedRuns = {{{"", 0, 4, 5, {}}, {"", 9, 9, 1, small}}, {}};
  // Counted from 1, as in the timeline.
  const QString text = outcomeText(calibrator(), outcome);
  QVERIFY2(text.contains(QStringLiteral("left: no board was found in frames 1–5, 10 (too small: ")),
           qPrintable(text));
  QVERIFY2(!text.contains(QStringLiteral("right: no board")), qPrintable(text));
}

void BoardPageTest::theFloorFrameCountsFromOne() {
  openRecording();
  BoardGuideRequest request = calibrator().guideRequest();
  request.board.floorFrame = 4;
  calibrator().setGuideRequest(request);
  auto* frame = find<QSpinBox>(QStringLiteral("boardFloorFrame"));
  QCOMPARE(frame->value(), 5);
  frame->setValue(8);
  QCOMPARE(*calibrator().guideRequest().board.floorFrame, std::int64_t{7});
}

void BoardPageTest::theCommandLineGivesTheSameBits() {
  openRecording();
  QVERIFY(calibrate());
  auto inputs = dewpoint::app::openProject(std::filesystem::path(file("board.toml").toStdString()));
  QVERIFY(inputs.has_value());
  const auto& request = calibrator().guideRequest();
  const auto seen = findBoards(inputs->project, *inputs->source, request.board);
  QVERIFY(seen.has_value());
  const auto outcome = calibrateFromBoards(inputs->project, *seen, request.board, request.goal);
  QVERIFY(outcome.has_value());
  QVERIFY(outcome->project.cameras == project().cameras);
}

void BoardPageTest::cancelKeepsWhatWas() {
  openRecording();
  const auto before = project().cameras;
  QSignalSpy over(&calibrator(), &BoardCalibrator::calibrationEnded);
  QTest::mouseClick(find<QPushButton>(QStringLiteral("boardCalibrate")), Qt::LeftButton);
  QVERIFY(find<QPushButton>(QStringLiteral("boardCancel"))->isVisible());
  QTest::mouseClick(find<QPushButton>(QStringLiteral("boardCancel")), Qt::LeftButton);
  QVERIFY(over.wait(kTimeoutMs));
  QVERIFY(project().cameras == before);
  QCOMPARE(history().count(), 0);
  QVERIFY2(result().contains(QStringLiteral("kept")), qPrintable(result()));
  QVERIFY(calibrate()); // and again
  QVERIFY(calibrator().isApplied());
}

void BoardPageTest::theShownBoardSetsTheFloor() {
  openRecording();
  QVERIFY(calibrate());
  const int steps = history().count();
  find<QAction>(QStringLiteral("actionCalibrateWorld"))->trigger();
  auto* button = find<QPushButton>(QStringLiteral("worldBoard"));
  QVERIFY(waitFor([&] { return button->isEnabled(); }));
  scrollTo(button);
  QTest::mouseClick(button, Qt::LeftButton);
  QVERIFY(waitFor([&] { return history().count() == steps + 1; }));
  // In the first frame, the board is straight in front of the cameras, 0.45 m away.
  for (const ProjectCamera& camera : project().cameras) {
    QVERIFY(std::abs(camera.camera.center().z() - 0.45) < 0.01);
  }
  history().undo();
  QVERIFY(std::abs(project().cameras[0].camera.center().z() - 0.45) > 0.1);
}

void BoardPageTest::printsAndReports() {
  openRecording();
  QSignalSpy saved(&calibrator(), &BoardCalibrator::saved);
  calibrator().printBoard(QStringLiteral("A4"), file("board.pdf"));
  QVERIFY(saved.wait(kTimeoutMs));
  QFile pdf(file("board.pdf"));
  QVERIFY(pdf.open(QIODevice::ReadOnly));
  QVERIFY(pdf.read(5) == "%PDF-");
  QVERIFY(calibrate());
  calibrator().saveReport(file("report.html"));
  QVERIFY(saved.wait(kTimeoutMs));
  QFile html(file("report.html"));
  QVERIFY(html.open(QIODevice::ReadOnly));
  const QByteArray text = html.readAll();
  QVERIFY(text.contains("<svg"));
  QVERIFY(text.contains("In this volume"));
  BoardGuideRequest large = calibrator().guideRequest();
  large.board.board.squareSize *= 3.0;
  large.board.board.markerSize *= 3.0;
  calibrator().setGuideRequest(large);
  QSignalSpy split(&calibrator(), &BoardCalibrator::printedOnSeveralSheets);
  calibrator().printBoard(QStringLiteral("A4"), file("sheets.pdf"));
  QVERIFY(split.wait(kTimeoutMs));
  QVERIFY(split.first().at(1).toInt() > 1);
  QSignalSpy failed(&calibrator(), &BoardCalibrator::failed);
  calibrator().printBoard(QStringLiteral("A4"), file("nowhere/board.pdf"));
  QVERIFY(failed.wait(kTimeoutMs));
}

void BoardPageTest::theBoardIsRemembered() {
  openRecording();
  window_.reset();
  openWindow(&openProject, file("board.toml").toStdString());
  QVERIFY(calibrator().guideRequest().board.board == shown_.board);
}

void BoardPageTest::liveCamerasAreGuidedToTheEnd() {
  openLive({true, true});
  BoardGuideRequest request = calibrator().guideRequest();
  request.lensGuidance.requiredProjectionSigmaPx = 20.0; // coarse: it ends after the fewest views
  request.requiredPositionSigma = 0.05;
  request.rigGuidance.instantsPerPair = 4;
  calibrator().setGuideRequest(request);
  const auto before = project().cameras;
  QSignalSpy over(&calibrator(), &BoardCalibrator::calibrationEnded);
  QTest::mouseClick(find<QPushButton>(QStringLiteral("boardStart")), Qt::LeftButton);
  // What was taken is solved only: whatever stage says how far it is, none of them looks for a
  // board.
  int solving = 0, looking = 0;
  connect(&calibrator(), &BoardCalibrator::progressChanged, this, [&](double part) {
    ++(calibrator().isSearchingRecording() || part >= 0.0 ? looking : solving);
  });
  // The board is moved on when a view was taken, or when this one gives nothing new.
  std::size_t taken = 0;
  int images = 0;
  connect(&calibrator(), &BoardCalibrator::guideChanged, this, [&] {
    const auto state = calibrator().guideState();
    std::size_t now = 0;
    for (const auto& camera : state->cameras) {
      now += camera.capturedOutlines.size();
    }
    if (now != taken || ++images > 12) {
      taken = now;
      images = 0;
      ++*place_;
    }
  });
  QVERIFY(waitFor([&] { return over.count() > 0; }));
  disconnect(&calibrator(), nullptr, this, nullptr);
  QVERIFY(solving > 0);
  QCOMPARE(looking, 0);
  QVERIFY2(calibrator().outcome() != nullptr, qPrintable(result()));
  QVERIFY(!calibrator().isGuiding());
  QVERIFY(project().cameras == before); // until it is wanted
  QVERIFY(find<QLabel>(QStringLiteral("boardAdvice0"))->isVisible());
  QTest::mouseClick(find<QPushButton>(QStringLiteral("boardApply")), Qt::LeftButton);
  QCOMPARE(history().count(), 1);
  const double apart =
      (project().cameras[0].camera.center() - project().cameras[1].camera.center()).norm();
  QVERIFY2(std::abs(apart - 0.1) < 0.01, qPrintable(QString::number(apart)));
  history().undo();
  QVERIFY(project().cameras == before);
}

void BoardPageTest::liveViewsCanBeTakenByHand() {
  openLive({true, false});
  QTest::mouseClick(find<QPushButton>(QStringLiteral("boardStart")), Qt::LeftButton);
  auto* capture = find<QPushButton>(QStringLiteral("boardCapture"));
  for (int k = 0; k < 9; ++k) {
    *place_ = k;
    const auto views = [&] {
      return calibrator().guideState()->detections->cameras[0].views.size();
    };
    const std::size_t before = views();
    QVERIFY(waitFor([&] { return calibrator().guideState()->cameras[0].detection.has_value(); }));
    QTest::mouseClick(capture, Qt::LeftButton);
    QVERIFY(waitFor([&] { return views() > before; }));
  }
  QVERIFY(find<QWidget>(QStringLiteral("boardLayer0"))->isVisible());
  scrollTo(find<QPushButton>(QStringLiteral("boardFinish")));
  keep(QStringLiteral("calibration-board-live"));
  // Something is drawn in the coverage: not what an empty one shows.
  auto* map = find<BoardMap>(QStringLiteral("boardMap0"));
  const QImage full = map->grab().toImage();
  QSignalSpy guide(&calibrator(), &BoardCalibrator::guideChanged);
  QTest::mouseClick(find<QPushButton>(QStringLiteral("boardStart")), Qt::LeftButton); // over
  QVERIFY(calibrator().guideState()->cameras[0].capturedOutlines.empty());
  QVERIFY(map->grab().toImage() != full);
  QTest::mouseClick(capture, Qt::LeftButton);
}

void BoardPageTest::theNextViewIsShownAcrossTheRoom() {
  openLive({true, false});
  QTest::mouseClick(find<QPushButton>(QStringLiteral("boardDisplay")), Qt::LeftButton);
  const QPointer<QWidget> display = find<QWidget>(QStringLiteral("roomDisplay"));
  QVERIFY(QTest::qWaitForWindowExposed(display));
  const auto text = [&](const char* name) { return find<QLabel>(QLatin1String(name))->text(); };
  QVERIFY(!text("roomAdvice").isEmpty()); // how to begin
  QTest::mouseClick(find<QPushButton>(QStringLiteral("boardStart")), Qt::LeftButton);
  QVERIFY(waitFor([&] { return calibrator().guideState()->cameras.size() == 2; }));
  QVERIFY(waitFor([&] { return calibrator().guideState()->cameras[0].detection.has_value(); }));
  QVERIFY(waitFor([&] { return !text("roomCamera").isEmpty(); }));
  const QString none = text("roomCount");
  QTest::mouseClick(find<QPushButton>(QStringLiteral("boardCapture")), Qt::LeftButton);
  QVERIFY(waitFor([&] { return text("roomCount") != none; }));
  QVERIFY(find<QLabel>(QStringLiteral("roomAdvice"))->font().pixelSize() >
          find<QLabel>(QStringLiteral("boardAdvice0"))->fontInfo().pixelSize());
  const QString folder = qEnvironmentVariable("DEWPOINT_SCREENSHOTS");
  QVERIFY(folder.isEmpty() ||
          display->grab().save(folder + QStringLiteral("/calibration-room-display.png")));
  QTest::keyClick(display, Qt::Key_Escape);
  QVERIFY(waitFor([&] { return display.isNull(); }));
  QTest::mouseClick(find<QPushButton>(QStringLiteral("boardStart")), Qt::LeftButton); // over
}

void BoardPageTest::everythingHasAName() {
  openRecording();
  for (QWidget* widget : find<QWidget>(QStringLiteral("boardPage"))->findChildren<QWidget*>()) {
    if (widget->focusPolicy() == Qt::NoFocus || qobject_cast<QLabel*>(widget) != nullptr ||
        widget->objectName().startsWith(QStringLiteral("qt_")) ||
        widget->inherits("QComboBoxListView")) { // Qt's own
      continue;
    }
    const auto* button = qobject_cast<QAbstractButton*>(widget);
    QVERIFY2(!widget->accessibleName().isEmpty() || (button && !button->text().isEmpty()),
             qPrintable(widget->objectName() + QStringLiteral(" ") +
                        QLatin1String(widget->metaObject()->className())));
    QVERIFY2(!widget->toolTip().isEmpty(), qPrintable(widget->objectName()));
  }
}

void BoardPageTest::theSearchIsKnownInAnotherLanguage() {
  const auto english = qScopeGuard([] { useLanguage(QStringLiteral("en")); });
  useLanguage(QStringLiteral("de"));
  openRecording();
  QSignalSpy over(&calibrator(), &BoardCalibrator::calibrationEnded);
  const QSignalSpy progress(&calibrator(), &BoardCalibrator::progressChanged);
  auto* start = find<QPushButton>(QStringLiteral("boardCalibrate"));
  scrollTo(start);
  QTest::mouseClick(start, Qt::LeftButton);
  QCOMPARE(find<QProgressBar>(QStringLiteral("boardProgress"))->format(),
           QStringLiteral("Suche die Tafel: %p %"));
  QVERIFY(over.wait(kTimeoutMs));
  // How far the search is, is known by its stage, not by what the window calls it.
  QVERIFY(!progress.isEmpty() && progress.first().first().toDouble() >= 0.0);
  QVERIFY(!calibrator().isSearchingRecording());
  QVERIFY2(calibrator().isApplied(), qPrintable(result()));
}

DEWPOINT_WINDOW_TEST(BoardPageTest)

} // namespace dewpoint::tests

#include "board_page_test.moc"
