// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/run_actions.h"

#include "core/session/session.h"
#include "core/session/snapshot/snapshot.h"
#include "ui/actions/action_registry.h"
#include "ui/actions/key_guard.h"
#include "ui/widgets/message_bar.h"
#include "ui/widgets/thread_count_dialog.h"
#include "ui/workbench/workbench.h"

#include <QAction>
#include <QMainWindow>
#include <QThread>

namespace dewpoint::ui {

namespace {

/// False: there is nothing to lose.
bool askToRestart(const Workbench& bench, bool newSeed) {
  const TrackSnapshotPtr& shown = bench.session.shownSnapshot();
  if (shown == nullptr || shown->history.newestTrackedFrame <= 0) {
    return false;
  }
  SessionController* run = &bench.session;
  bench.messages.showQuestion(
      SessionController::tr("Restart the run? The results so far will be lost."),
      {{SessionController::tr("Restart"), [run, newSeed] { run->restart(newSeed); }}});
  return true;
}

/// False: the recording has not ended, or there is nothing to lose.
bool askToPlayAgain(const Workbench& bench) {
  const TrackSnapshotPtr& shown = bench.session.shownSnapshot();
  if (shown == nullptr || shown->state != PlayState::Ended ||
      shown->history.newestTrackedFrame <= 0) {
    return false;
  }
  SessionController* run = &bench.session;
  bench.messages.showQuestion(
      SessionController::tr("The recording has ended. Track it again from the beginning? The "
                            "results so far will be lost."),
      {{SessionController::tr("Track from the beginning"), [run] { run->togglePlay(); }}});
  return true;
}

} // namespace

void installRunActions(const Workbench& bench) {
  SessionController* run = &bench.session;
  bench.onTriggered("actionPlay", run, [run] { run->togglePlay(); });
  bench.onTriggered("actionNextFrame", run, [run] { run->session()->stepFrame(); });
  bench.onTriggered("actionNextIteration", run, [run] { run->session()->stepIteration(); });
  bench.onTriggered("actionRestart", run, [run] { run->restart(false); });
  bench.onTriggered("actionRestartNewSeed", run, [run] { run->restart(true); });
  bench.onTriggered("actionFilterThreads", run, [run, bench] {
    auto* dialog = new ThreadCountDialog(QThread::idealThreadCount(), &bench.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    QObject::connect(dialog, &QDialog::accepted, run, &SessionController::applyFilterThreadCount);
    Workbench::presentDialog(dialog);
  });
  for (const bool newSeed : {false, true}) {
    new KeyGuard(
        bench.action(newSeed ? ActionId("actionRestartNewSeed") : ActionId("actionRestart")),
        [bench, newSeed] { return askToRestart(bench, newSeed); });
  }
  new KeyGuard(bench.action("actionPlay"), [bench] { return askToPlayAgain(bench); });
  bench.requireRun({"actionPlay", "actionNextFrame", "actionNextIteration", "actionRestart",
                    "actionRestartNewSeed"});
  QObject::connect(run, &SessionController::snapshotChanged, &bench.actions,
                   [bench] { // also when there is no run any more
                     QAction* play = bench.action("actionPlay");
                     bench.session.isPlaying()
                         ? bench.actions.rename(play, QT_TRANSLATE_NOOP("Actions", "Pause"),
                                                "pause")
                         : bench.actions.rename(play, QT_TRANSLATE_NOOP("Actions", "Play"), "play");
                   });
}

} // namespace dewpoint::ui
