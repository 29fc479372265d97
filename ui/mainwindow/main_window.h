// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/actions/command_palette.h"
#include "ui/document/recovery.h"
#include "ui/session/project_loader.h"
#include "ui/style/theme.h"

#include <QMainWindow>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

class QAction;
class QDockWidget;
class QMenu;
class QStackedWidget;

namespace dewpoint::project {
struct Project;
} // namespace dewpoint::project
namespace dewpoint::session {
struct TrackSnapshot;
} // namespace dewpoint::session

namespace dewpoint::ui {

class BirdsEyeView;
class BoardCalibrator;
class CameraMotionAlerts;
class CalibrationDock;
class CameraView;
class CameraPanel;
class ColorPanel;
class ConvergencePlot;
class Document;
class GridLayer;
class ManualCalibration;
class LongJob;
class MessageBar;
class NewProjectPage;
class ParameterPanel;
class RigPlanner;
class PeoplePanel;
class AddPersonTool;
class PlotPanel;
class PointCalibrator;
class Selection;
class StartPage;
class SessionBridge;
class StatusBarPanel;
class TargetPanel;
class Timeline;
class ActionRegistry;
class TrajectoryPanel;
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

  /// Keeps unsaved work in this folder, and offers what an earlier window left there.
  void useRecovery(const std::filesystem::path& folder);
  /// Speaks another language from now on, and remembers it.
  void setLanguage(const QString& language);

  /// Writes trajectory.csv and run.json of the run so far into a folder; what failed is said in the
  /// window, too. False also when nothing is open.
  bool saveRun(const std::filesystem::path& folder);

  Document& document() { return *document_; }
  const Document& document() const { return *document_; }
  Selection& selection() { return *selection_; }
  /// The newest snapshot shown; null before a project is open.
  TrackSnapshotPtr shown() const { return shown_; }

Q_SIGNALS:
  void projectOpened();
  void openFailed(const QString& sentence);
  /// All views have been given this snapshot.
  void snapshotShown(TrackSnapshotPtr snapshot);

protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  /// Keys do not reach into docks that lie behind another tab.
  bool focusNextPrevChild(bool next) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  void makeStart();
  void showStart(bool shown);
  void showViews(bool shown);
  void beginNewProject(const QStringList& files);
  void openUnsaved(const Project& project, const QString& note,
                   const std::optional<RecoverableWork>& recovered = {});
  void recover(const RecoverableWork& work);
  void throwAway(const RecoverableWork& work);
  void closeProject();
  void fillRecentMenu(QMenu* menu);
  void fillViewMenu(QMenu* view);
  void fillLanguageMenu(QMenu* menu);
  std::vector<CommandPalette::Entry> moreForPalette();
  void offerRecovery();
  void makeInspector();
  void makeCalibration();
  void makeCalibrationFiles();
  void makeBoardPage();
  void showCalibration(bool shown);
  void showHandles();
  void makePlan();
  void openPlan();
  void makeBumps();
  void makePeople();
  void connectPeople();
  /// The docks and actions that the method has a use for.
  void suitMethod();
  void placePeople(bool placing);
  void exportPeople();
  void writePeople(const QString& folder);
  void resolveCamera(int camera);
  void takeCalibration();
  void connectRooms();
  void takeEmptyRooms();
  void loadCalibrationOf(const QString& file);
  void clearViews();
  void resetLayout();
  void keepLayout();
  void openShortcuts();
  void sayHistory();
  void makeDocks();
  void makeTimeline();
  void connectTravel();
  void showMoment(const TrackSnapshot& snapshot);
  void makeToolBar();
  void makeMenus();
  void connectActions();
  void connectRun();
  void linkViews();
  QDockWidget* makeDock(const QString& name, const std::function<QString()>& title,
                        QWidget* content);
  void makeCameraDocks();
  void arrange();
  void shareSpace();
  void toggleMaximized(QDockWidget* dock);

  /// Opens the document as it is again: its cameras are not those of the session any more.
  void reopen();
  void adoptInputs(SessionInputs inputs);
  void startSession(SessionInputs inputs, bool unsaved);
  void showSnapshot(const TrackSnapshotPtr& snapshot);
  void takeMethod();
  void pullLog();
  void showNotices(const TrackSnapshot& snapshot);
  QAction* action(const char* id) const;
  void updateTitle();
  void updateEnabled();

  void trackLearned(int target, bool isNew);
  bool followsBoxes() const;
  void showFamily();
  void sayWhatMethodNeeds();
  void exportBoxes();
  void togglePlay();
  void restart(bool newSeed);
  void askOpen();
  void askSaveAs();
  void save();
  void saveTo(std::filesystem::path file);
  void exportTrajectory();
  void openExperiments();
  void addPictureMenu(QDockWidget* dock, QWidget* bar);
  void choosePicture();
  void savePictureOf(QDockWidget* dock);
  bool mayDiscard();

  ProjectLoader* loader_;
  Document* document_;
  Selection* selection_;
  SessionBridge* bridge_ = nullptr;
  ActionRegistry* actions_;
  MessageBar* messages_ = nullptr;
  CameraMotionAlerts* bumps_ = nullptr;
  StatusBarPanel* figures_ = nullptr;
  BirdsEyeView* birdsEye_ = nullptr;
  PlotPanel* plot_ = nullptr;
  TrajectoryPanel* trajectory_ = nullptr;
  Timeline* timeline_ = nullptr;
  ParameterPanel* parameters_ = nullptr;
  QStackedWidget* start_ = nullptr;
  StartPage* startPage_ = nullptr;
  NewProjectPage* newProject_ = nullptr;
  CommandPalette* palette_ = nullptr;
  TargetPanel* targets_ = nullptr;
  ColorPanel* color_ = nullptr;
  PeoplePanel* people_ = nullptr;
  AddPersonTool* placer_ = nullptr;
  LongJob* peopleJob_ = nullptr;
  QDockWidget* peopleDock_ = nullptr;
  QDockWidget* colorDock_ = nullptr;
  CameraPanel* cameras_ = nullptr;
  ManualCalibration* hand_ = nullptr;
  PointCalibrator* points_ = nullptr;
  RigPlanner* plan_ = nullptr;
  BoardCalibrator* board_ = nullptr;
  CalibrationDock* calibration_ = nullptr;
  QDockWidget* calibrationDock_ = nullptr;
  std::vector<GridLayer*> gridLayers_; ///< one per camera view
  QDockWidget* targetDock_ = nullptr;
  QDockWidget* cameraListDock_ = nullptr;
  LongJob* emptyRoomJob_ = nullptr;
  Recovery* recovery_ = nullptr;
  QDockWidget* birdsEyeDock_ = nullptr;
  QDockWidget* plotDock_ = nullptr;
  QDockWidget* trajectoryDock_ = nullptr;
  QDockWidget* timelineDock_ = nullptr;
  QDockWidget* parameterDock_ = nullptr;
  QDockWidget* historyDock_ = nullptr;
  QDockWidget* maximized_ = nullptr;
  QByteArray layoutBeforeMaximized_;
  QByteArray layoutBehindPages_; ///< of the views while the start page or another is shown
  std::vector<QDockWidget*> cameraDocks_;
  std::vector<CameraView*> cameraViews_;
  TrackSnapshotPtr shown_;
  std::uint64_t logGeneration_ = 0;
  std::size_t logPosition_ = 0;
  std::uint64_t frameGeneration_ = 0;
  std::size_t framePosition_ = 0;
  std::size_t noticesShown_ = 0;
  Theme theme_ = Theme::System;
  bool playOnOpen_ = true;
  /// What is being opened, and what becomes of the document then.
  struct Opening {
    bool keepHistory = false; ///< the same project, with other inputs
    bool unsaved = false;     ///< it is in no file as it is
    QString note;             ///< said once it is open
    std::optional<RecoverableWork> recovered;
  };
  Opening opening_;
  bool offered_ = false; ///< unsaved work of an earlier window
};

} // namespace dewpoint::ui
