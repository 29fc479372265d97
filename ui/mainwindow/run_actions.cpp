// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/run_actions.h"

#include "core/session/session.h"
#include "ui/actions/action_registry.h"
#include "ui/workbench/workbench.h"

#include <QAction>

namespace dewpoint::ui {

void installRunActions(const Workbench& bench) {
  SessionController* run = &bench.session;
  bench.onTriggered("actionPlay", run, [run] { run->togglePlay(); });
  bench.onTriggered("actionNextFrame", run, [run] { run->session()->stepFrame(); });
  bench.onTriggered("actionNextIteration", run, [run] { run->session()->stepIteration(); });
  bench.onTriggered("actionRestart", run, [run] { run->restart(false); });
  bench.onTriggered("actionRestartNewSeed", run, [run] { run->restart(true); });
  bench.needRun({"actionPlay", "actionNextFrame", "actionNextIteration", "actionRestart",
                 "actionRestartNewSeed"});
  QObject::connect(run, &SessionController::snapshotChanged, &bench.actions,
                   [bench](const TrackSnapshotPtr& snapshot) {
                     if (snapshot == nullptr) {
                       return;
                     }
                     QAction* play = bench.action("actionPlay");
                     bench.session.isPlaying()
                         ? bench.actions.rename(play, QT_TRANSLATE_NOOP("Actions", "Pause"),
                                                "pause")
                         : bench.actions.rename(play, QT_TRANSLATE_NOOP("Actions", "Play"), "play");
                   });
}

} // namespace dewpoint::ui
