// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/wiring/open_project.h"
#include "tests/ui/wait.h"
#include "ui/mainwindow/main_window.h"

#include <QAction>
#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

namespace dewpoint::tests::test {

/// How a window is made for a test.
struct WindowSetup {
  ProjectOpener opener = &openProject;
  QSize size = {}; ///< empty: as large as the window wants to be
  std::optional<Theme> theme = {};
  bool play = true; ///< a project plays as soon as it is open
  bool show = true; ///< else the test shows it when it is ready
};

/// The real window on a display, what tests look up in it and wait for, and a folder of the test's
/// own. A test inherits it beside QObject.
class WindowFixture : protected Waiting {
protected:
  WindowFixture();
  ~WindowFixture();

  /// Forgets all settings and makes the window.
  void makeWindow(const WindowSetup& setup = {});
  /// Makes the window as the last one left the settings.
  void makeAnotherWindow(const WindowSetup& setup = {});

  /// The child of the window with this object name; ends the program when there is none.
  template <class T> T* find(const QString& name) const {
    T* found = window_->findChild<T*>(name);
    if (found == nullptr) {
      qFatal("no child named %s", qPrintable(name));
    }
    return found;
  }
  template <class T> T* find(const char* name) const { return find<T>(QLatin1String(name)); }
  QAction* action(const char* name) const { return find<QAction>(name); }
  QString messageText() const;

  /// The newest snapshot shown; an empty one before there is any.
  const TrackSnapshot& shown() const;
  /// Opens a project (the demo: an empty path) and waits until it is open.
  void open(const std::filesystem::path& project = {});
  /// Opens the demo by its button on the start page.
  void openDemo();
  /// Waits until a project with so many cameras is shown.
  bool isOpen(std::size_t cameras) const;
  /// Drops files onto the window.
  void drop(const QStringList& files);
  /// Waits until the layout is done and all views have drawn what they were given.
  static bool draws(const QWidget& widget);
  /// Waits until, moreover, the widget's picture no longer changes: not for live cameras.
  static bool settles(QWidget& widget);
  /// Waits until no job runs beside the window any more, and what they found has come: not for a
  /// window whose views still change.
  static bool jobsEnd();
  /// Scrolls the areas around a part of the window until it can be seen.
  static void scrollTo(QWidget* part);

  /// A file in the test's folder.
  QString file(const char* name) const { return folder_.filePath(QLatin1String(name)); }
  std::filesystem::path path(const char* name) const { return file(name).toStdString(); }

  QTemporaryDir folder_;
  std::unique_ptr<MainWindow> window_;
};

} // namespace dewpoint::tests::test
