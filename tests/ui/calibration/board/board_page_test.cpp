// SPDX-License-Identifier: GPL-3.0-or-later
// Calibrating with a board in the real window: a recording, and live cameras.
#include "core/session/snapshot/snapshot.h"
#include "core/setup/calibration/board_outcome.h"
#include "tests/ui/calibration/board/shown_board.h"
#include "tests/ui/window_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/calibration/board/board_calibrator.h"
#include "ui/calibration/board/board_map.h"
#include "ui/document/document.h"
#include "ui/widgets/message_bar.h"

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QUndoStack>

#include <memory>
#include <utility>

namespace dewpoint::tests {

class BoardPageTest : public QObject, private test::WindowFixture {
  Q_OBJECT

private Q_SLOTS:
  void initTestCase();
  void init();
  void cleanup();
  void aRecordingCalibratesInOneStep();
  void theCommandLineGivesTheSameBits();
  void cancelKeepsWhatWas();
  void aWrongBoardIsSaid();
  void theBoardFindsItself();
  void liveCamerasShowWhichBoardItIs();
  void printsAndReports();
  void theBoardIsRemembered();
  void liveCamerasAreGuidedToTheEnd();
  void liveViewsCanBeTakenByHand();
  void everythingHasAName();

private:
  const Project& project() { return window_->document().project(); }
  QUndoStack& history() { return *window_->document().undoStack(); }
  BoardCalibrator& calibrator() { return *window_->findChild<BoardCalibrator*>(); }
  QString result() { return find<QLabel>(QStringLiteral("boardResult"))->text(); }

  MessageBar& messages() { return *window_->findChild<MessageBar*>(); }
  /// The button of a message; null if it has none with that text.
  QPushButton* answer(const QString& text);
  void expectShownBoard();
  void openWindow(const ProjectOpener& opener, const std::filesystem::path& project);
  void openRecording();
  void openLive(const BoardGoal& goal);
  void setBoard(const BoardGoal& goal);
  bool calibrate();
  /// A picture of the window in both themes, as the manual shows it: into the folder that
  /// DEWPOINT_SCREENSHOTS names, or beside the test.
  void keep(const QString& name);

  test::ShownBoard shown_;
  std::shared_ptr<std::atomic<int>> place_;
};

void BoardPageTest::initTestCase() {
  QVERIFY(folder_.isValid());
  QVERIFY(shown_.record(folder_.path().toStdString()));
}

void BoardPageTest::init() {
  QSettings().clear();
}

void BoardPageTest::cleanup() {
  window_.reset();
}

void BoardPageTest::openWindow(const ProjectOpener& opener, const std::filesystem::path& project) {
  makeAnotherWindow({.opener = opener, .size = {1500, 950}, .theme = Theme::Light, .play = false});
  QVERIFY(QTest::qWaitForWindowActive(window_.get()));
  open(project);
  QVERIFY(waitFor([this] { return shown().frames != nullptr; }));
  QTest::keyClick(window_.get(), Qt::Key_C, Qt::ShiftModifier);
  QVERIFY(find<QWidget>(QStringLiteral("boardPage"))->isVisible());
}

void BoardPageTest::setBoard(const BoardGoal& goal) {
  BoardGuideRequest request = calibrator().request();
  request.board.board = shown_.board;
  request.goal = goal;
  calibrator().setRequest(request);
}

void BoardPageTest::openRecording() {
  openWindow(&openProject, file("board.toml").toStdString());
  setBoard({true, true});
}

void BoardPageTest::openLive(const BoardGoal& goal) {
  place_ = std::make_shared<std::atomic<int>>(0);
  openWindow(
      [this](const SessionRequest&) -> Result<SessionInputs> {
        SessionInputs inputs;
        inputs.project = shown_.project();
        inputs.source = std::make_unique<test::LiveBoard>(shown_, place_);
        return inputs;
      },
      {});
  QVERIFY(waitFor([&] { return calibrator().isLive(); }));
  setBoard(goal);
}

bool BoardPageTest::calibrate() {
  QSignalSpy over(&calibrator(), &BoardCalibrator::calibrated);
  QTest::mouseClick(find<QPushButton>(QStringLiteral("boardCalibrate")), Qt::LeftButton);
  return over.wait(kTimeoutMs);
}

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
  QVERIFY(!calibrator().isSearching());
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

void BoardPageTest::theCommandLineGivesTheSameBits() {
  openRecording();
  QVERIFY(calibrate());
  auto inputs = dewpoint::app::openProject(std::filesystem::path(file("board.toml").toStdString()));
  QVERIFY(inputs.has_value());
  const auto& request = calibrator().request();
  const auto seen = findBoards(inputs->project, *inputs->source, request.board);
  QVERIFY(seen.has_value());
  const auto outcome = calibrateFromBoards(inputs->project, *seen, request.board, request.goal);
  QVERIFY(outcome.has_value());
  QVERIFY(outcome->project.cameras == project().cameras);
}

void BoardPageTest::cancelKeepsWhatWas() {
  openRecording();
  const auto before = project().cameras;
  QSignalSpy over(&calibrator(), &BoardCalibrator::calibrated);
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

void BoardPageTest::aWrongBoardIsSaid() {
  openRecording();
  find<QComboBox>(QStringLiteral("boardKind"))->setCurrentIndex(0);
  Q_EMIT find<QComboBox>(QStringLiteral("boardKind"))->activated(0);
  find<QSpinBox>(QStringLiteral("boardColumns"))->setValue(12);
  QCOMPARE(calibrator().request().board.board.columns, 11); // inner corners
  QVERIFY(calibrate());
  QVERIFY(!calibrator().isApplied());
  QCOMPARE(history().count(), 0);
  // The board that the recording shows is named, and one button describes it.
  QVERIFY2(result().contains(QStringLiteral("charuco:7x5:")), qPrintable(result()));
  QVERIFY(calibrator().proposal().has_value());
  QVERIFY2(messages().text().contains(QStringLiteral("DICT_4X4_50")),
           qPrintable(messages().text()));
  QVERIFY(answer(QStringLiteral("Search all frames")) == nullptr); // 16 frames: all were searched
  QTest::mouseClick(answer(QStringLiteral("Use this board")), Qt::LeftButton);
  expectShownBoard();
  QCOMPARE(history().count(), 0); // no project data
  QVERIFY(calibrate());
  QVERIFY2(calibrator().isApplied(), qPrintable(result()));
}

void BoardPageTest::theBoardFindsItself() {
  openRecording();
  auto* findButton = find<QPushButton>(QStringLiteral("boardFind"));
  QVERIFY(findButton->isEnabled());
  // As it is described: a notice.
  QSignalSpy confirmed(&calibrator(), &BoardCalibrator::boardConfirmed);
  scrollTo(findButton);
  QTest::mouseClick(findButton, Qt::LeftButton);
  QVERIFY(!findButton->isEnabled());
  QVERIFY(confirmed.wait(kTimeoutMs));
  QVERIFY(!calibrator().proposal());
  // Another one is proposed; the lengths stay.
  BoardGuideRequest request = calibrator().request();
  request.board.board = parseBoard("chessboard:9x6:0.04").value();
  calibrator().setRequest(request);
  QSignalSpy proposed(&calibrator(), &BoardCalibrator::boardProposed);
  QVERIFY(waitFor([&] { return findButton->isEnabled(); }));
  QTest::mouseClick(findButton, Qt::LeftButton);
  QVERIFY(proposed.wait(kTimeoutMs));
  QVERIFY(answer(QStringLiteral("Search all frames")) == nullptr); // nothing was searched
  QTest::mouseClick(answer(QStringLiteral("Use this board")), Qt::LeftButton);
  expectShownBoard();
  QCOMPARE(calibrator().request().board.board.squareSize, 0.04);
  QCOMPARE(find<QSpinBox>(QStringLiteral("boardColumns"))->value(), 7);
  QCOMPARE(find<QComboBox>(QStringLiteral("boardKind"))->currentIndex(), 1);
  QCOMPARE(history().count(), 0);
}

void BoardPageTest::liveCamerasShowWhichBoardItIs() {
  openLive({true, false});
  BoardGuideRequest request = calibrator().request();
  request.board.board = parseBoard("chessboard:9x6:0.03").value();
  calibrator().setRequest(request);
  QSignalSpy proposed(&calibrator(), &BoardCalibrator::boardProposed);
  auto* findButton = find<QPushButton>(QStringLiteral("boardFind"));
  scrollTo(findButton);
  QTest::mouseClick(findButton, Qt::LeftButton);
  QVERIFY(proposed.wait(kTimeoutMs));
  calibrator().useProposal();
  expectShownBoard();
}

void BoardPageTest::expectShownBoard() {
  const BoardDescription& board = calibrator().request().board.board;
  QCOMPARE(board.kind, shown_.board.kind);
  QCOMPARE(board.columns, shown_.board.columns);
  QCOMPARE(board.rows, shown_.board.rows);
  QCOMPARE(QString::fromStdString(board.dictionary),
           QString::fromStdString(shown_.board.dictionary));
}

QPushButton* BoardPageTest::answer(const QString& text) {
  for (auto* button : messages().findChildren<QPushButton*>()) {
    if (button->text() == text && button->isVisible()) {
      return button;
    }
  }
  return nullptr;
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
  QSignalSpy failed(&calibrator(), &BoardCalibrator::failed);
  calibrator().printBoard(QStringLiteral("A4"), file("nowhere/board.pdf"));
  QVERIFY(failed.wait(kTimeoutMs));
}

void BoardPageTest::theBoardIsRemembered() {
  openRecording();
  window_.reset();
  openWindow(&openProject, file("board.toml").toStdString());
  QVERIFY(calibrator().request().board.board == shown_.board);
}

void BoardPageTest::liveCamerasAreGuidedToTheEnd() {
  openLive({true, true});
  BoardGuideRequest request = calibrator().request();
  request.lenses.requestedProjectionPx = 20.0; // coarse: it ends after the fewest views
  request.requiredPositionSigma = 0.05;
  request.rig.instantsPerPair = 4;
  calibrator().setRequest(request);
  const auto before = project().cameras;
  QSignalSpy over(&calibrator(), &BoardCalibrator::calibrated);
  QTest::mouseClick(find<QPushButton>(QStringLiteral("boardStart")), Qt::LeftButton);
  // What was taken is solved only: whatever stage says how far it is, none of them looks for a
  // board.
  int solving = 0, looking = 0;
  connect(&calibrator(), &BoardCalibrator::progressChanged, this,
          [&](double part) { ++(calibrator().isSearching() || part >= 0.0 ? looking : solving); });
  // The board is moved on when a view was taken, or when this one gives nothing new.
  std::size_t taken = 0;
  int images = 0;
  connect(&calibrator(), &BoardCalibrator::guideChanged, this, [&] {
    const auto state = calibrator().guide();
    std::size_t now = 0;
    for (const auto& camera : state->cameras) {
      now += camera.taken.size();
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
  QVERIFY(!calibrator().isWatching());
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
    const auto views = [&] { return calibrator().guide()->seen->cameras[0].views.size(); };
    const std::size_t before = views();
    QVERIFY(waitFor([&] { return calibrator().guide()->cameras[0].seen.has_value(); }));
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
  QVERIFY(calibrator().guide()->cameras[0].taken.empty());
  QVERIFY(map->grab().toImage() != full);
  QTest::mouseClick(capture, Qt::LeftButton);
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

DEWPOINT_WINDOW_TEST(BoardPageTest)

} // namespace dewpoint::tests

#include "board_page_test.moc"
