// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/added_view/frame_clock.h"

#include "ui/workbench/dock_manager.h"
#include "ui/workbench/workbench.h"

#include <QMainWindow>

namespace dewpoint::ui {

void installFrameClock(const Workbench& bench) {
  auto* view = new FrameClock(&bench.window);
  bench.docks.makeDock({.name = QStringLiteral("frameClockDock"),
                        .title = [] { return FrameClock::tr("Frame"); },
                        .content = view});
  bench.connectView(view);
}

} // namespace dewpoint::ui
