// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/board/board_installer.h"

#include "core/session/session.h"
#include "ui/calibration/board/board_calibration_page.h"
#include "ui/calibration/board/board_calibrator.h"
#include "ui/calibration/board/board_layer.h"
#include "ui/calibration/board/board_text.h"
#include "ui/calibration/calibration_mode.h"
#include "ui/cameraview/camera_docks.h"
#include "ui/cameraview/camera_view.h"
#include "ui/widgets/message_bar.h"

namespace dewpoint::ui {

void installBoardCalibration(const Workbench& bench, CalibrationMode& mode,
                             const CameraDocks& cameras) {
  auto* board = new BoardCalibrator(bench.document, bench.session.opener(), &mode);
  auto* page = new BoardCalibrationPage(*board);
  mode.addPage(page, [] { return BoardCalibrationPage::tr("Board"); });
  bench.onTriggered("actionCalibrateBoard", board,
                    [&mode] { mode.open(QStringLiteral("boardPage")); });
  bench.onTriggered("actionPrintBoard", page, [page] { page->print(); });
  bench.requireRun({"actionCalibrateBoard"});
  bench.connectView(board);
  QObject::connect(&cameras, &CameraDocks::viewCreated, board,
                   [board](int camera, CameraView* view) { new BoardLayer(camera, view, *board); });
  QObject::connect(board, &BoardCalibrator::playRequested, &bench.session, [run = &bench.session] {
    if (run->shownSnapshot() && !run->isPlaying()) {
      run->play();
    }
  });
  QObject::connect(board, &BoardCalibrator::boardVisibilityChanged, &bench.session,
                   [run = &bench.session](bool shown) {
                     if (run->isRunning()) {
                       run->session()->setCalibrationBoardShown(shown);
                     }
                   });
  MessageBar* messages = &bench.messages;
  QObject::connect(
      board, &BoardCalibrator::boardProposed, messages, [board, messages](bool stopped) {
        std::vector<MessageBar::Answer> answers{
            {BoardCalibrationPage::tr("Use this board"), [board] { board->useProposal(); }}};
        if (stopped) {
          answers.emplace_back(BoardCalibrationPage::tr("Search all frames"),
                               [board] { board->searchAllFrames(); });
        }
        messages->showQuestion(proposalQuestion(*board->proposal()), answers);
      });
  QObject::connect(board, &BoardCalibrator::mirroredVideosFound, messages, [board, messages] {
    messages->showQuestion(
        mirroredVideosQuestion(*board),
        {{BoardCalibrationPage::tr("Mirror images"), [board] { board->mirrorImages(); }}});
  });
  QObject::connect(
      board, &BoardCalibrator::boardConfirmed, messages, [messages](int images, int searched) {
        messages->showNotice(BoardCalibrationPage::tr(
                                 "%1 of the %2 searched images show the board that you described.")
                                 .arg(QString::number(images), QString::number(searched)));
      });
  QObject::connect(board, &BoardCalibrator::failed, messages, &MessageBar::showError);
  QObject::connect(board, &BoardCalibrator::saved, messages, [messages](const QString& file) {
    messages->showNotice(BoardCalibrationPage::tr("Saved %1.").arg(file));
  });
  QObject::connect(board, &BoardCalibrator::printedOnSeveralSheets, messages,
                   [messages](const QString& file, int sheets) {
                     messages->showNotice(
                         BoardCalibrationPage::tr("Saved %1: the board is larger than the paper. "
                                                  "Page 1 shows how to put its %2 sheets together.")
                             .arg(file, QString::number(sheets)));
                   });
}

} // namespace dewpoint::ui
