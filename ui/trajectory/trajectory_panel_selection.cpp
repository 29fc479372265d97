// SPDX-License-Identifier: GPL-3.0-or-later
// What is selected in the trajectory panel, and what it shows of the selection.
#include "ui/plots/plot_stack.h"
#include "ui/trajectory/gap_list.h"
#include "ui/trajectory/trajectory_model.h"
#include "ui/trajectory/trajectory_panel.h"

#include <QTableView>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

namespace {
constexpr std::size_t kMostPlaces = 4000; ///< of a span in the room
} // namespace

void TrajectoryPanel::chooseRows() {
  if (choosing_) {
    return;
  }
  const auto selected = table_->selectionModel()->selection();
  choosing_ = true; // the rows stay as they were chosen
  if (selected.isEmpty()) {
    selection_.selectSpan(std::nullopt);
  } else {
    const auto& rows = model_->log().rows();
    const auto& top = rows[static_cast<std::size_t>(selected.front().top())].sample;
    const auto& bottom = rows[static_cast<std::size_t>(selected.front().bottom())].sample;
    const auto target = std::ranges::find(names_, top.target);
    if (target != names_.end()) {
      selection_.selectTarget(static_cast<int>(target - names_.begin()));
    }
    selection_.selectSpan(FrameSpan{top.frame, bottom.frame});
  }
  choosing_ = false;
}

void TrajectoryPanel::showSpan() {
  const bool byRows = choosing_;
  fetch(); // the span may be of samples that were not fetched while nobody looked
  gaps_->setSpan(selection_.span());
  if (!byRows) {
    selectSpan();
  }
  choosing_ = byRows;
  highlight();
}

void TrajectoryPanel::selectSpan() {
  choosing_ = true;
  const auto [first, last] =
      selection_.span() ? model_->rowsOf(*selection_.span()) : std::pair(0, 0);
  if (first < last) {
    const QItemSelection rows(model_->index(first, 0),
                              model_->index(last - 1, TrajectoryModel::ColumnCount - 1));
    table_->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
    table_->selectionModel()->setCurrentIndex(model_->index(first, 0),
                                              QItemSelectionModel::NoUpdate);
    table_->scrollTo(model_->index(first, 0));
  } else {
    table_->clearSelection();
  }
  choosing_ = false;
}

void TrajectoryPanel::highlight() {
  std::vector<std::vector<Eigen::Vector3d>> strokes;
  const auto [first, last] =
      selection_.span() ? model_->rowsOf(*selection_.span()) : std::pair(0, 0);
  const auto& rows = model_->log().rows();
  const auto count = static_cast<std::size_t>(last - first);
  const std::size_t step = count / (kMostPlaces + 1) + 1;
  bool joined = false;
  std::size_t seen = 0;
  for (int row = first; row < last; ++row) {
    const TrajectorySample& sample = rows[static_cast<std::size_t>(row)].sample;
    if (sample.target != target_) {
      continue;
    }
    if (!sample.valid || !sample.position.allFinite()) {
      joined = false;
      continue;
    }
    if (!joined) {
      strokes.emplace_back();
    }
    if (!joined || seen % step == 0) {
      strokes.back().push_back(sample.position);
    }
    joined = true;
    ++seen;
  }
  Q_EMIT highlightChanged(strokes);
}

void TrajectoryPanel::placeMoment() {
  // At the newest frame there is no line: the curves end there.
  const auto& rows = model_->log().rows();
  const bool past = !rows.empty() && selection_.moment() < rows.back().sample.frame;
  plots_->setMoment(past ? std::optional<std::int64_t>(selection_.moment()) : std::nullopt);
}

void TrajectoryPanel::choosePlace(int target, const Eigen::Vector3d& place, bool extend) {
  fetch();
  if (target < 0 || static_cast<std::size_t>(target) >= names_.size()) {
    return;
  }
  const std::string& name = names_[static_cast<std::size_t>(target)];
  const auto& rows = model_->log().rows();
  const auto found = std::find_if(rows.rbegin(), rows.rend(), [&](const MotionLog::Row& row) {
    return row.sample.target == name && row.sample.position == place;
  });
  if (found == rows.rend()) {
    return;
  }
  selection_.selectTarget(target);
  if (extend && selection_.moment() >= 0) {
    selection_.selectSpan(FrameSpan{selection_.moment(), found->sample.frame});
  } else {
    selection_.wantMoment(found->sample.frame);
  }
}

} // namespace dewpoint::ui
