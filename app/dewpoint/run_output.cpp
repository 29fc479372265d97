// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint/run_output.h"

#include "core/session/snapshot/snapshot.h"
#include "ui/mainwindow/main_window.h"

#include <QCoreApplication>

#include <cstdio>
#include <utility>

namespace dewpoint::app {

RunOutput::RunOutput(MainWindow& window, std::filesystem::path folder)
    : window_(window), folder_(std::move(folder)) {
  QObject::connect(&window, &MainWindow::snapshotShown, &window,
                   [this](const TrackSnapshotPtr& snapshot) {
                     const bool now = snapshot->state == PlayState::Ended;
                     if (!std::exchange(ended_, now) && now) {
                       write({});
                     }
                   });
  QObject::connect(qApp, &QCoreApplication::aboutToQuit, &window, [this] {
    if (window_.shown() != nullptr) {
      write([folder = folder_](bool written) {
        if (!written) {
          std::fprintf(stderr, "dewpoint: %s: the run could not be written\n", folder.c_str());
        }
      });
    }
  });
}

RunOutput::~RunOutput() {
  for (int left = *pendingWrites_; left > 0; left = *pendingWrites_) {
    pendingWrites_->wait(left);
  }
}

void RunOutput::write(const std::function<void(bool)>& written) {
  ++*pendingWrites_;
  window_.saveRun(folder_, [written, underWay = pendingWrites_](bool good) {
    if (written) {
      written(good);
    }
    --*underWay;
    underWay->notify_all();
  });
}

} // namespace dewpoint::app
