// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint/run_output.h"

#include "core/session/run/snapshot.h"
#include "ui/mainwindow/main_window.h"

#include <QCoreApplication>

#include <cstdio>
#include <memory>

namespace dewpoint::app {

void writeRunTo(MainWindow& window, const std::filesystem::path& folder) {
  const auto ended = std::make_shared<bool>(false);
  QObject::connect(&window, &MainWindow::snapshotShown, &window,
                   [&window, folder, ended](const TrackSnapshotPtr& snapshot) {
                     const bool now = snapshot->state == PlayState::Ended;
                     if (now && !*ended) {
                       window.saveRun(folder);
                     }
                     *ended = now;
                   });
  QObject::connect(qApp, &QCoreApplication::aboutToQuit, &window, [&window, folder] {
    if (window.shown() != nullptr && !window.saveRun(folder)) {
      std::fprintf(stderr, "dewpoint: %s: the run could not be written\n", folder.c_str());
    }
  });
}

} // namespace dewpoint::app
