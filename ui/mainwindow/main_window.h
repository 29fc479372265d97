// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/document/recovery_folder.h"
#include "ui/preferences/preferences.h"
#include "ui/session/project_loader.h"

#include <QMainWindow>

#include <filesystem>
#include <functional>
#include <memory>

namespace dewpoint::session {
struct TrackSnapshot;
} // namespace dewpoint::session

namespace dewpoint::ui {

class ActionRegistry;
class DockManager;
class CameraListModel;
class Document;
class HistoryDock;
class MessageBar;
class MessageRow;
class NoticeList;
class ProjectController;
class ProjectSaver;
class RunWriter;
class Selection;
class SessionController;
class WindowMenus;
class WindowThemes;
class TargetListModel;
struct Workbench;
using TrackSnapshotPtr = std::shared_ptr<const TrackSnapshot>;

/// Main window. Creates the parts shared by all features, and installs the features.
class MainWindow : public QMainWindow {
  Q_OBJECT
public:
  explicit MainWindow(ProjectOpener opener, QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Opens a project in the background. An empty path opens the demo, a built-in scene.
  void openProject(const std::filesystem::path& file);
  /// Sets whether projects start to play as soon as they are open.
  void setPlayOnOpen(bool play);
  void setTheme(Theme theme);
  Theme theme() const;

  /// Restores the window size and position from the last session, and saves them on close.
  void restoreAndSaveGeometry();
  /// Keeps a copy of unsaved work in this folder, and offers copies that earlier windows left
  /// there. `write` is the function that writes the copies; `writeTextFile()` by default.
  void enableRecovery(const std::filesystem::path& folder, TextWriter write = {});
  /// Offers to show the crash reports that earlier windows left in this folder.
  void offerCrashReports(const std::filesystem::path& folder);
  /// Returns the object that saves projects to their files.
  ProjectSaver& saver();
  /// Changes the language and saves it in the preferences.
  void setLanguage(const QString& language);

  /// Writes the results of the run so far (`RunRecord`) to a folder, in another thread. Requests
  /// are processed in order, even if the window closes meanwhile. Errors are shown in the window.
  /// `written` is called from the writing thread with true on success. If no project is open,
  /// `written` is called immediately with false.
  void saveRun(const std::filesystem::path& folder, std::function<void(bool)> written = {});

  Document& document() { return *document_; }
  const Document& document() const { return *document_; }
  Selection& selection() { return *selection_; }
  /// Returns the shared parts of the window that are needed to add further views.
  const Workbench& workbench() const { return *bench_; }
  /// Returns the newest snapshot shown, or null before a project is open.
  TrackSnapshotPtr shown() const;

Q_SIGNALS:
  void projectOpened();
  void openFailed(const QString& sentence);
  /// Emitted when all views have received this snapshot.
  void snapshotShown(TrackSnapshotPtr snapshot);

protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  /// Moves the focus, skipping docks behind another tab.
  bool focusNextPrevChild(bool next) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  void installFeatures();
  void installStatusBar();
  void connectRun();
  void placeMessageRow();
  void updateTitle();

  Document* document_;
  CameraListModel* cameraList_;
  TargetListModel* targetList_;
  Selection* selection_;
  SessionController* session_;
  ActionRegistry* actions_;
  DockManager* docks_;
  MessageBar* messages_;
  NoticeList* notices_;
  MessageRow* messageRow_ = nullptr; ///< row for the message bar in the window
  std::unique_ptr<Workbench> bench_;
  ProjectController* projects_ = nullptr;
  HistoryDock* history_ = nullptr;
  WindowMenus* menus_ = nullptr;
  RunWriter* runWriter_;
  WindowThemes* themes_ = nullptr;
  bool keepsGeometry_ = false;
};

} // namespace dewpoint::ui
