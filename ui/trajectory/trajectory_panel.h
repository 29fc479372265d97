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
class TableHead;
class TrajectoryModel;

/// The trajectory of the run: a table that follows the frame shown, speed and height over time, and
/// the gaps. A range selected in any of them is selected in all. Of a run that follows boxes in
/// images: its boxes.
class TrajectoryPanel : public QWidget {
  Q_OBJECT
public:
  /// Session::samplesSince() of the session followed.
  using Source =
      std::function<Session::SamplesPiece(std::uint64_t& generation, std::size_t& position)>;

  /// Connects the registry's trajectory actions.
  TrajectoryPanel(ActionRegistry& actions, Selection& selection, QWidget* parent = nullptr);
  ~TrajectoryPanel() override;

  /// What is followed; an empty function: nothing, and the table becomes empty.
  void follow(Source source);
  /// There may be new samples: fetches them soon, and only while the panel is visible.
  void refresh();
  /// The newest snapshot: which targets there are.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// The user points at a position of a target's trajectory: requests that frame, or, to `extend`,
  /// selects the range from the current frame to it.
  void choosePlace(int target, const Eigen::Vector3d& place, bool extend);
  /// The boxes of a run whose method follows those.
  BoxPanel& boxes() { return *boxes_; }
  PlotStack& plots() { return *plots_; }
  /// The rows selected, or all: onto the clipboard, prepared in a thread.
  void copyCsv();
  /// What the last fetching and drawing took, milliseconds.
  double lastRefreshMs() const { return lastRefreshMs_; }

  QSize sizeHint() const override { return {900, 240}; }

Q_SIGNALS:
  void notice(const QString& sentence);
  /// The correction of this target at this frame is to be taken away.
  void correctionRemovalWanted(qint64 frame, int target);
  /// The positions of the selected range, meters: one stroke for each uninterrupted piece.
  void highlightChanged(const std::vector<std::vector<Eigen::Vector3d>>& strokes);

protected:
  void showEvent(QShowEvent* event) override;

private:
  void setTarget(const std::string& name);
  void showSelectedRange();
  /// At a place of the screen; with what can be done to a row of the table, if it is about one.
  void showMenu(const QPoint& place, int row);
  void showCurrentFrame();
  void makeTable();
  void makePlots();
  void connectViews();
  void fetch();
  void updatePlots(std::size_t firstChanged);
  void chooseRows();
  void selectRange();
  void highlight();
  void updateSummary();

  ActionRegistry& actions_;
  Selection& selection_;
  TrajectoryModel* model_;
  QTableView* table_;
  TableHead* head_ = nullptr;
  GapList* gaps_;
  QLabel* summary_;
  PlotStack* plots_;
  BoxPanel* boxes_;
  QStackedLayout* pages_;
  MotionSeries motion_;            ///< of one target
  std::vector<std::string> names_; ///< of all targets
  Source source_;
  std::uint64_t generation_ = 0;
  std::size_t position_ = 0;
  bool choosing_ = false; ///< rows are being selected, but not by the user
  QTimer timer_;
  QElapsedTimer sinceRefresh_;
  double lastRefreshMs_ = 0.0;
  LatestJob csv_{LatestJob::Overtaken::Kept}; ///< for the clipboard
};

} // namespace dewpoint::ui
