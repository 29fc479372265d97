// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"
#include "ui/jobs/latest_job.h"
#include "ui/selection/selection.h"
#include "ui/trajectory/motion_series.h"

#include <Eigen/Core>
#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <functional>
#include <optional>
#include <string>
#include <vector>

class QLabel;
class QStackedLayout;
class QTableView;

namespace dewpoint::session {
struct TrackSnapshot;
} // namespace dewpoint::session

namespace dewpoint::ui {

class ActionRegistry;
class BoxPanel;
class GapList;
class PlotStack;
class FrameRowDelegate;
class TrajectoryModel;

/// Panel with the trajectory of the run: a table that follows the frame shown, plots of speed and
/// height over time, and the gaps. A range selected in one of these is selected in all. For methods
/// that track bounding boxes, the panel shows the boxes instead.
class TrajectoryPanel : public QWidget {
  Q_OBJECT
public:
  /// Function that returns the samples added since `position`, and updates both arguments, as
  /// Session::samplesSince() of the session to follow does.
  using Source =
      std::function<LogUpdate<TrajectorySample>(std::uint64_t& generation, std::size_t& position)>;

  /// Creates the panel, and connects the trajectory actions in the registry to it.
  TrajectoryPanel(ActionRegistry& actions, Selection& selection, QWidget* parent = nullptr);
  ~TrajectoryPanel() override;

  /// Sets the source of the samples. An empty function means no source and clears the table.
  void setSource(Source source);
  /// Schedules fetching new samples. They are fetched only while the panel is visible.
  void refresh();
  /// Sets the newest snapshot, which provides the targets.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Handles a click on a position in a target's trajectory. Requests the frame of this position
  /// or, if `extend` is true, selects the range from the current frame to this frame.
  void choosePosition(int target, const Eigen::Vector3d& position, bool extend);
  /// Returns the panel with the bounding boxes, for methods that track boxes.
  BoxPanel& boxPanel() { return *boxes_; }
  PlotStack& plots() { return *plots_; }
  /// Copies the selected rows, or all rows if none are selected, to the clipboard. The text is
  /// prepared in another thread.
  void copyCsv();
  /// Returns the duration of the last fetch and redraw in milliseconds.
  double lastRefreshMs() const { return lastRefreshMs_; }

  QSize sizeHint() const override { return {900, 240}; }

Q_SIGNALS:
  void noticeRequested(const QString& sentence);
  /// Emitted when the user wants to remove this target's correction at this frame.
  void correctionRemovalRequested(qint64 frame, int target);
  /// Emitted with the positions in the selected range (meters), one list per uninterrupted part.
  void highlightChanged(const std::vector<std::vector<Eigen::Vector3d>>& strokes);

protected:
  void showEvent(QShowEvent* event) override;

private:
  void setTarget(const std::string& name);
  void showSelectedRange();
  /// Opens the menu at a screen position, with the entries for a table row. If `row` is negative,
  /// the menu has no such entries.
  void showMenu(const QPoint& place, int row);
  void showCurrentFrame();
  void makeTable();
  void makePlots();
  void connectViews();
  void fetch();
  void updatePlots(std::size_t firstChangedRow);
  void chooseRows();
  void selectRange();
  void highlight();
  void updateSummary();

  ActionRegistry& actions_;
  Selection& selection_;
  TrajectoryModel* model_;
  QTableView* table_;
  FrameRowDelegate* head_ = nullptr;
  GapList* gaps_;
  QLabel* summary_;
  PlotStack* plots_;
  BoxPanel* boxes_;
  QStackedLayout* pages_;
  MotionSeries motion_;            ///< speed and height of one target
  std::vector<std::string> names_; ///< names of all targets
  Source source_;
  std::uint64_t generation_ = 0;
  std::size_t position_ = 0;
  bool choosing_ = false; ///< the program is selecting rows
  QTimer timer_;
  QElapsedTimer sinceRefresh_;
  double lastRefreshMs_ = 0.0;
  LatestJob csv_{LatestJob::SupersededJob::Kept}; ///< prepares the clipboard text
};

} // namespace dewpoint::ui
