// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/job_queue.h"
#include "ui/plots/plot_series.h"

#include <QStringList>
#include <QWidget>

#include <memory>
#include <vector>

class QAction;
class QLabel;
class QMenu;

namespace dewpoint::session {
struct IterationRecord;
struct TrackSnapshot;
} // namespace dewpoint::session

namespace dewpoint::ui {

class ActionRegistry;
class FrameConvergence;
class PlotStack;
class Selection;
using TrackSnapshotPtr = std::shared_ptr<const TrackSnapshot>;

/// The plots of a run: position and spread per axis, effective sample size, likelihood and
/// existence per camera, error against truth and time per step of one target, over iterations or
/// time; beside them the convergence within the frame shown. Which are shown is the user's choice
/// and remembered.
class PlotPanel : public QWidget {
  Q_OBJECT
public:
  /// Connects the registry's plot actions.
  PlotPanel(ActionRegistry& actions, Selection& selection, QWidget* parent = nullptr);
  ~PlotPanel() override;

  /// Iterations since the last call.
  void append(const std::vector<IterationRecord>& records);
  /// A new run: what comes next is from its start.
  void clear();
  /// Whose cameras the curves are of; null: no run, and no curves.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Whose numbers are shown, from 0.
  void setTarget(int target);
  int shownIterations() const;
  FrameConvergence& convergence() { return *convergence_; }
  PlotStack& stack() { return *stack_; }

  /// Buttons and the position of the cursor, for the title of the dock.
  QWidget* makeTools(QWidget* parent);
  void copyCsv();
  /// SVG or PNG, by the name's ending, written beside the window; notice() or failed() follows.
  void savePicture(const QString& file);

Q_SIGNALS:
  void notice(const QString& sentence);
  void failed(const QString& sentence);

private:
  void connectActions();
  void fillMenu(QMenu* menu) const;
  void keepChoice();
  void useCameras();
  void askSave();
  void showCurrentFrame();
  void updateTargetName();
  PlotSeries& seriesOf(int target);

  ActionRegistry& actions_;
  Selection& selection_;
  PlotStack* stack_;
  FrameConvergence* convergence_;
  QLabel* targetName_ = nullptr; ///< in the title of the dock
  QStringList cameras_;
  QStringList targets_;
  bool camerasKnown_ = false;
  bool showsBoxes_ = false; ///< curves of boxes in images, else of positions
  std::vector<std::unique_ptr<PlotSeries>> series_; ///< per target
  int target_ = 0;
  JobQueue files_;
};

} // namespace dewpoint::ui
