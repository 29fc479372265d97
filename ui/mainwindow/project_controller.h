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

/// Controls how work begins and ends: the pages in the center of the window; opening, saving and
/// closing projects; recent projects; dropped files; and the question before unsaved changes are
/// lost.
class ProjectController : public QObject {
  Q_OBJECT
public:
  /// Creates the pages as the central widget of the window.
  explicit ProjectController(const Workbench& bench);

  /// Opens a project in the background; empty path: the demo.
  void open(const std::filesystem::path& file);
  /// Shows the start page.
  void showStart();
  /// Keeps a copy of unsaved work in this folder, and offers copies that an earlier window left
  /// there.
  void useRecovery(const std::filesystem::path& folder, TextWriter write);
  ProjectSaver& saver() { return *saver_; }
  /// Whether the window may close now. If the user first saves, the window closes afterwards.
  /// Removes the recovery copy of discarded work.
  bool mayClose();
  void fillRecentMenu(QMenu* menu);
  /// Whether the data contain something that can be opened.
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
  /// Takes `file` by value, because it may be the path stored in the project.
  void saveTo(std::filesystem::path file);
  void close();
  /// Asks about unsaved changes. Returns true to continue. Returns false to stop; if the user chose
  /// to save, `saved` runs once the project is saved.
  bool mayDiscard(const std::function<void()>& saved);
  /// Runs `next` as soon as it would lose no unsaved changes.
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
  std::function<void()> afterSaving_; ///< runs once the project is saved
};

} // namespace dewpoint::ui
