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

class NewProjectPage;
class ProjectSaver;
class RecentMenu;
class RecentProjects;
class Recovery;
class RecoveryOffer;
class StartPage;
class ThumbnailKeeper;

/// How work begins and ends: the pages in the center of the window, opening, saving and closing
/// projects, recent ones, dropped files, and the question before unsaved changes are lost.
class ProjectController : public QObject {
  Q_OBJECT
public:
  /// Makes the pages, as the central widget of the window.
  explicit ProjectController(const Workbench& bench);

  /// Opens a project in the background; empty path: the demo.
  void open(const std::filesystem::path& file);
  /// Shows the start page.
  void showStart();
  /// Keeps unsaved work in this folder, and offers what an earlier window left there.
  void useRecovery(const std::filesystem::path& folder, TextWriter write);
  ProjectSaver& saver() { return *saver_; }
  /// Whether the window may close now; it is closed later if its work is saved first. The copy of
  /// what was given up goes.
  bool mayClose();
  void fillRecentMenu(QMenu* menu);
  /// Whether there is anything that could be opened.
  static bool canDrop(const QMimeData& data);
  void drop(const QMimeData& data);

private:
  void makePages();
  void connectPages();
  void connectActions();
  void connectRun();
  void connectOpening();
  void openScene(const QString& name, bool calibrate);
  void connectSaver();
  void beginNew(const QStringList& files);
  void openMade(const Project& project, const QString& note);
  void askOpen();
  void askSaveAs();
  void save();
  void saveTo(std::filesystem::path file); ///< by value: it may be the project's own
  void close();
  /// Asks about unsaved changes. True: go on. False: not now; `saved` runs once they are saved, if
  /// that was the answer.
  bool mayDiscard(const std::function<void()>& saved);
  /// Runs `next` as soon as nothing unsaved is lost by it.
  void whenSettled(const std::function<void()>& next);

  Workbench bench_;
  RecentProjects* recent_;
  RecentMenu* recentMenu_;
  ThumbnailKeeper* thumbnails_;
  QStackedWidget* pages_ = nullptr;
  StartPage* startPage_ = nullptr;
  NewProjectPage* newProject_ = nullptr;
  RecoveryOffer* recovery_ = nullptr;
  ProjectSaver* saver_;
  std::function<void()> afterSaving_; ///< what waits until the project is in its file
};

} // namespace dewpoint::ui
