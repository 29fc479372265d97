// SPDX-License-Identifier: GPL-3.0-or-later
// The page *Board* finds out by itself which board a recording or live cameras show.
#include "tests/ui/calibration/board/board_page_fixture.h"
#include "tests/ui/window_test.h"
#include "ui/widgets/message_bar.h"

#include <QComboBox>
#include <QSpinBox>

namespace dewpoint::tests {

class BoardSearchPageTest : public QObject, private test::BoardPageFixture {
  Q_OBJECT

private Q_SLOTS:
  void initTestCase() { record(); }
  void init() { QSettings().clear(); }
  void cleanup() { window_.reset(); }
  void aWrongBoardIsSaid();
  void theBoardFindsItself();
  void aMirroredVideoIsMendedWithOneClick();
  void liveCamerasShowWhichBoardItIs();

private:
  MessageBar& messages() { return *window_->findChild<MessageBar*>(); }
  /// The button of a message; null if it has none with that text.
  QPushButton* answer(const QString& text);
  void expectShownBoard();
};

void BoardSearchPageTest::aWrongBoardIsSaid() {
  openRecording();
  find<QComboBox>(QStringLiteral("boardKind"))->setCurrentIndex(0);
  Q_EMIT find<QComboBox>(QStringLiteral("boardKind"))->activated(0);
  find<QSpinBox>(QStringLiteral("boardColumns"))->setValue(12);
  QCOMPARE(calibrator().guideRequest().board.board.columns, 11); // inner corners
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

void BoardSearchPageTest::theBoardFindsItself() {
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
  BoardGuideRequest request = calibrator().guideRequest();
  request.board.board = parseBoard("chessboard:9x6:0.04").value();
  calibrator().setGuideRequest(request);
  QSignalSpy proposed(&calibrator(), &BoardCalibrator::boardProposed);
  QVERIFY(waitFor([&] { return findButton->isEnabled(); }));
  QTest::mouseClick(findButton, Qt::LeftButton);
  QVERIFY(proposed.wait(kTimeoutMs));
  QVERIFY(answer(QStringLiteral("Search all frames")) == nullptr); // nothing was searched
  QTest::mouseClick(answer(QStringLiteral("Use this board")), Qt::LeftButton);
  expectShownBoard();
  QCOMPARE(calibrator().guideRequest().board.board.squareSize, 0.04);
  QCOMPARE(find<QSpinBox>(QStringLiteral("boardColumns"))->value(), 7);
  QCOMPARE(find<QComboBox>(QStringLiteral("boardKind"))->currentIndex(), 1);
  QCOMPARE(history().count(), 0);
}

void BoardSearchPageTest::aMirroredVideoIsMendedWithOneClick() {
  // The camera mirrors the images of its file: as if the file were mirrored.
  Project mirrored = shown_.project();
  mirrored.cameras[1].isMirrored = true;
  QVERIFY(saveProject(mirrored, file("mirrored.toml").toStdString()).has_value());
  openWindow(&openProject, file("mirrored.toml").toStdString());
  setBoard({true, true});
  QSignalSpy found(&calibrator(), &BoardCalibrator::mirroredVideosFound);
  QVERIFY(calibrate());
  QCOMPARE(found.count(), 1);
  QVERIFY2(messages().text().contains(QStringLiteral("video of right is mirrored")),
           qPrintable(messages().text()));
  const int steps = history().count();
  QTest::mouseClick(answer(QStringLiteral("Mirror images")), Qt::LeftButton);
  QVERIFY(!project().cameras[1].isMirrored);
  QVERIFY(!project().cameras[0].isMirrored);
  QCOMPARE(history().count(), steps + 1);
  QVERIFY(waitFor([this] { return shown().frames != nullptr; }));
  QVERIFY(
      waitFor([this] { return find<QPushButton>(QStringLiteral("boardCalibrate"))->isEnabled(); }));
  QVERIFY(calibrate());
  QVERIFY2(calibrator().isApplied(), qPrintable(result()));
}

void BoardSearchPageTest::liveCamerasShowWhichBoardItIs() {
  openLive({true, false});
  BoardGuideRequest request = calibrator().guideRequest();
  request.board.board = parseBoard("chessboard:9x6:0.03").value();
  calibrator().setGuideRequest(request);
  QSignalSpy proposed(&calibrator(), &BoardCalibrator::boardProposed);
  auto* findButton = find<QPushButton>(QStringLiteral("boardFind"));
  scrollTo(findButton);
  QTest::mouseClick(findButton, Qt::LeftButton);
  QVERIFY(proposed.wait(kTimeoutMs));
  calibrator().useProposal();
  expectShownBoard();
}

void BoardSearchPageTest::expectShownBoard() {
  const BoardDescription& board = calibrator().guideRequest().board.board;
  QCOMPARE(board.kind, shown_.board.kind);
  QCOMPARE(board.columns, shown_.board.columns);
  QCOMPARE(board.rows, shown_.board.rows);
  QCOMPARE(QString::fromStdString(board.dictionary),
           QString::fromStdString(shown_.board.dictionary));
}

QPushButton* BoardSearchPageTest::answer(const QString& text) {
  for (auto* button : messages().findChildren<QPushButton*>()) {
    if (button->text() == text && button->isVisible()) {
      return button;
    }
  }
  return nullptr;
}

DEWPOINT_WINDOW_TEST(BoardSearchPageTest)

} // namespace dewpoint::tests

#include "board_search_page_test.moc"
