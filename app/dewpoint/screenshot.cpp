// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint/screenshot.h"

#include "core/session/snapshot/snapshot.h"
#include "ui/cameraview/camera_view.h"
#include "ui/mainwindow/main_window.h"

#include <QAction>
#include <QApplication>
#include <QFileInfo>
#include <QPixmap>
#include <QTimer>

#include <algorithm>
#include <cstdio>
#include <memory>

namespace dewpoint::app {

namespace {

/// The bird's-eye view draws at a lower rate of its own: let it catch up with the last frame.
constexpr int kSettleMs = 1500;
/// Between two looks at whether the camera views have drawn theirs.
constexpr int kLookMs = 20;

void fail(const QString& sentence) {
  std::fprintf(stderr, "dewpoint: %s\n", qPrintable(sentence));
  QApplication::exit(1);
}

void grabTo(MainWindow& window, const QString& file) {
  const QString path = QFileInfo(file).absoluteFilePath();
  if (!window.grab().save(path, "PNG")) {
    fail(QStringLiteral("%1: the file cannot be written").arg(path));
    return;
  }
  std::printf("%s\n", qPrintable(path));
  QApplication::exit(0);
}

void grabWhenDrawn(MainWindow& window, const QString& file) {
  const auto views = window.findChildren<CameraView*>();
  if (std::ranges::all_of(views, [](const CameraView* view) { return view->isDrawn(); })) {
    grabTo(window, file);
  } else { // pictures are made beside the window
    QTimer::singleShot(kLookMs, &window, [&window, file] { grabWhenDrawn(window, file); });
  }
}

} // namespace

void takeScreenshot(MainWindow& window, const QString& file, int frames) {
  QObject::connect(&window, &MainWindow::openFailed, &window, fail);
  const auto done = std::make_shared<bool>(false);
  QObject::connect(
      &window, &MainWindow::snapshotShown, &window,
      [&window, file, frames, done](const TrackSnapshotPtr& snapshot) {
        const bool reached = snapshot->frame + 1 >= frames || snapshot->state == PlayState::Ended;
        if (*done || !reached) {
          return;
        }
        *done = true;
        if (snapshot->state == PlayState::Playing) {
          window.findChild<QAction*>(QStringLiteral("actionPlay"))->trigger(); // pause
        }
        QTimer::singleShot(kSettleMs, &window, [&window, file] { grabWhenDrawn(window, file); });
      });
}

} // namespace dewpoint::app
