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

/// Plots of a run, for one target: position and spread per axis, effective sample size, likelihood
/// and existence probability per camera, error relative to the ground truth, and time per step,
/// over iterations or time. Next to them is the convergence within the frame shown. The user
/// selects which plots are shown; the preferences store the selection.
class PlotPanel : public QWidget {
  Q_OBJECT
public:
  /// Creates the panel, and connects the plot actions in the registry to it.
  PlotPanel(ActionRegistry& actions, Selection& selection, QWidget* parent = nullptr);
  ~PlotPanel() override;

  /// Adds the iterations that were logged since the last call.
  void append(const std::vector<IterationRecord>& records);
  /// Clears the plots for a new run.
  void clear();
  /// Sets the snapshot, which provides the camera names. Null means that there is no run and no
  /// curves are shown.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Sets the index of the target to show, counted from 0.
  void setTarget(int target);
  int shownIterationCount() const;
  FrameConvergence& convergence() { return *convergence_; }
  PlotStack& stack() { return *stack_; }

  /// Creates the widget for the dock title, with buttons and the position of the cursor as text.
  QWidget* makeTitleTools(QWidget* parent);
  void copyCsv();
  /// Writes the plots as SVG or PNG, depending on the suffix, in another thread. Emits
  /// `noticeRequested()` or `failed()` afterwards.
  void savePicture(const QString& file);

Q_SIGNALS:
  void noticeRequested(const QString& sentence);
  void failed(const QString& sentence);

private:
  void connectActions();
  void fillMenu(QMenu* menu) const;
  void saveShownPlots();
  void updateCameras();
  void chooseImageFile();
  void showCurrentFrame();
  void updateTargetName();
  PlotSeries& seriesOf(int target);

  ActionRegistry& actions_;
  Selection& selection_;
  PlotStack* stack_;
  FrameConvergence* convergence_;
  QLabel* targetName_ = nullptr; ///< in the dock title
  QStringList cameras_;
  QStringList targets_;
  bool camerasKnown_ = false;
  bool showsBoxes_ = false; ///< whether the curves show bounding boxes instead of positions
  std::vector<std::unique_ptr<PlotSeries>> series_; ///< one per target
  int target_ = 0;
  JobQueue files_;
};

} // namespace dewpoint::ui
