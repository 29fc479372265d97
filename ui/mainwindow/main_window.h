// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/mainwindow/project_loader.h"
#include "ui/settings/theme.h"

#include <QMainWindow>

#include <cstdint>
#include <memory>
#include <vector>

class QDockWidget;

namespace dewpoint {

class BirdsEyeView;
class CameraView;
class ConvergencePlot;
class Document;
class MessageBar;
class ParameterPanel;
class SessionBridge;
class StatusFigures;
class TransportActions;
struct TrackSnapshot;
using TrackSnapshotPtr = std::shared_ptr<const TrackSnapshot>;

/// The window: it only assembles views, actions, document and session.
class MainWindow : public QMainWindow {
  Q_OBJECT
public:
  explicit MainWindow(ProjectOpener opener, QWidget* parent = nullptr);
  ~MainWindow() override;

  /// Opens a project in the background; empty path: the demo.
  void openProject(const std::filesystem::path& file);
  /// Whether a project plays as soon as it is open.
  void setPlayOnOpen(bool play) { playOnOpen_ = play; }
  void setTheme(Theme theme);
  Theme theme() const { return theme_; }

  /// Writes trajectory.csv and run.json of the run so far into a folder; what failed is said in the
  /// window, too. False also when nothing is open.
  bool saveRun(const std::filesystem::path& folder);

  Document& document() { return *document_; }
  /// The newest snapshot shown; null before a project is open.
  TrackSnapshotPtr shown() const { return shown_; }

Q_SIGNALS:
  void projectOpened();
  void openFailed(const QString& sentence);
  /// All views have been given this snapshot.
  void snapshotShown(TrackSnapshotPtr snapshot);

protected:
  void closeEvent(QCloseEvent* event) override;

private:
  void makeDocks();
  void makeToolBar();
  void makeMenus();
  void connectActions();
  void connectRun();
  QDockWidget* makeDock(const QString& name, const QString& title, QWidget* content);
  void makeCameraDocks();
  void arrange();
  void shareSpace();
  void toggleMaximized(QDockWidget* dock);

  void adoptInputs(SessionInputs inputs);
  void showSnapshot(const TrackSnapshotPtr& snapshot);
  void pullLog();
  void showNotices(const TrackSnapshot& snapshot);
  void updateTitle();
  void updateEnabled();

  void togglePlay();
  void restart(bool newSeed);
  void askOpen();
  void askSaveAs();
  void save();
  void saveTo(const std::filesystem::path& file);
  void exportTrajectory();
  bool mayDiscard();

  ProjectLoader* loader_;
  Document* document_;
  SessionBridge* bridge_ = nullptr;
  TransportActions* actions_;
  MessageBar* messages_ = nullptr;
  StatusFigures* figures_ = nullptr;
  BirdsEyeView* birdsEye_ = nullptr;
  ConvergencePlot* plot_ = nullptr;
  ParameterPanel* parameters_ = nullptr;
  QDockWidget* birdsEyeDock_ = nullptr;
  QDockWidget* plotDock_ = nullptr;
  QDockWidget* parameterDock_ = nullptr;
  QDockWidget* maximized_ = nullptr;
  QByteArray layoutBeforeMaximized_;
  std::vector<QDockWidget*> cameraDocks_;
  std::vector<CameraView*> cameraViews_;
  TrackSnapshotPtr shown_;
  std::uint64_t logGeneration_ = 0;
  std::size_t logPosition_ = 0;
  std::size_t noticesShown_ = 0;
  Theme theme_ = Theme::System;
  bool playOnOpen_ = true;
};

} // namespace dewpoint
