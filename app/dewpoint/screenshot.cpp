// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint/screenshot.h"

#include "core/session/run/snapshot.h"
#include "ui/mainwindow/main_window.h"

#include <QAction>
#include <QApplication>
#include <QFileInfo>
#include <QPixmap>
#include <QTimer>

#include <cstdio>
#include <memory>

namespace dewpoint::app {

namespace {

/// The bird's-eye view draws at a lower rate of its own: let it catch up with the last frame.
constexpr int kSettleMs = 1500;

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
        QTimer::singleShot(kSettleMs, &window, [&window, file] { grabTo(window, file); });
      });
}

} // namespace dewpoint::app
