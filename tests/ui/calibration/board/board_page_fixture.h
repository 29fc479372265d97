// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/wiring/open_project.h"
#include "tests/ui/calibration/board/shown_board.h"
#include "tests/ui/window_fixture.h"
#include "ui/calibration/board/board_calibrator.h"
#include "ui/document/document.h"

#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QUndoStack>

#include <memory>

namespace dewpoint::tests::test {

/// The real window with the page *Board* open, for a recording of a board or live cameras.
class BoardPageFixture : public WindowFixture {
protected:
  const Project& project() { return window_->document().project(); }
  QUndoStack& history() { return *window_->document().undoStack(); }
  BoardCalibrator& calibrator() { return *window_->findChild<BoardCalibrator*>(); }
  QString result() { return find<QLabel>(QStringLiteral("boardResult"))->text(); }

  /// Makes the recording that openRecording() opens.
  void record() {
    QVERIFY(folder_.isValid());
    QVERIFY(shown_.record(folder_.path().toStdString()));
  }

  void openWindow(const ProjectOpener& opener, const std::filesystem::path& project) {
    makeAnotherWindow(
        {.opener = opener, .size = {1500, 950}, .theme = Theme::Light, .play = false});
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    open(project);
    QVERIFY(waitFor([this] { return shown().frames != nullptr; }));
    QTest::keyClick(window_.get(), Qt::Key_C, Qt::ShiftModifier);
    QVERIFY(find<QWidget>(QStringLiteral("boardPage"))->isVisible());
  }

  void setBoard(const BoardGoal& goal) {
    BoardGuideRequest request = calibrator().guideRequest();
    request.board.board = shown_.board;
    request.goal = goal;
    calibrator().setGuideRequest(request);
  }

  void openRecording() {
    openWindow(&openProject, file("board.toml").toStdString());
    setBoard({true, true});
  }

  void openLive(const BoardGoal& goal) {
    place_ = std::make_shared<std::atomic<int>>(0);
    openWindow(
        [this](const SessionRequest&) -> Result<SessionInputs> {
          SessionInputs inputs;
          inputs.project = shown_.project();
          inputs.source = std::make_unique<LiveBoard>(shown_, place_);
          return inputs;
        },
        {});
    QVERIFY(waitFor([&] { return calibrator().usesLiveCameras(); }));
    setBoard(goal);
  }

  bool calibrate() {
    QSignalSpy over(&calibrator(), &BoardCalibrator::calibrationEnded);
    QTest::mouseClick(find<QPushButton>(QStringLiteral("boardCalibrate")), Qt::LeftButton);
    return over.wait(kTimeoutMs);
  }

  ShownBoard shown_;
  std::shared_ptr<std::atomic<int>> place_;
};

} // namespace dewpoint::tests::test
