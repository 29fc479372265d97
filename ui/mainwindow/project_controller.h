// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/recovery_folder.h"
#include "ui/workbench/workbench.h"

#include <filesystem>
#include <functional>

class QMenu;
class QMimeData;
class QStackedWidget;

namespace dewpoint::project {
struct Project;
} // namespace dewpoint::project

namespace dewpoint::ui {

class ChangesGuard;
class NewProjectPage;
class ProjectSaver;
class RecentMenu;
class RecentProjects;
class Recovery;
class RecoveryOffer;
class StartPage;
class ThumbnailWriter;

/// Opens, creates, saves and closes projects. This includes the pages in the center of the window,
/// recent projects, dropped files, and the question before unsaved changes are lost.
class ProjectController : public QObject {
  Q_OBJECT
public:
  /// Creates the pages as the window's central widget.
  explicit ProjectController(const Workbench& bench);

  /// Opens a project in the background. An empty path opens the demo, a built-in scene.
  void open(const std::filesystem::path& file);
  /// Shows the start page.
  void showStartPage();
  /// Keeps a copy of unsaved work in this folder, and offers copies that earlier windows left
  /// there.
  void enableRecovery(const std::filesystem::path& folder, TextWriter write);
  ProjectSaver& saver();
  /// Asks the user about unsaved changes, and returns whether the window may close now. If the user
  /// chooses to save, returns false, and the window closes once the changes are saved. If it
  /// returns true, the copy of unsaved work is removed.
  bool confirmClose();
  void fillRecentMenu(QMenu* menu);
  /// Returns whether data dragged over the window contain a file that can be opened.
  static bool canDrop(const QMimeData& data);
  void drop(const QMimeData& data);

private:
  void makePages();
  void connectPages();
  void connectActions();
  void connectRun();
  void connectOpening();
  void openScene(const QString& name, bool calibrate);
  /// `findsCalibration`: as in NewProjectPage::startNewProject().
  void showNewProjectPage(const QStringList& files, bool findsCalibration = true);
  void openCreated(const Project& project, const QString& note);
  void chooseProject();
  void close();

  Workbench bench_;
  RecentProjects* recent_;
  RecentMenu* recentMenu_;
  ThumbnailWriter* thumbnails_;
  QStackedWidget* pages_ = nullptr;
  StartPage* startPage_ = nullptr;
  NewProjectPage* newProject_ = nullptr;
  bool guideNewProject_ = false; ///< whether the calibration guide opens with the new project
  RecoveryOffer* recovery_ = nullptr;
  ChangesGuard* changes_;
};

} // namespace dewpoint::ui
