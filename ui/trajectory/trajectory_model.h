// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/motion.h"
#include "ui/selection/selection.h"

#include <QAbstractTableModel>

#include <utility>

namespace dewpoint::ui {

/// Table model of a run's trajectory, with one row per target and frame. The table grows with the
/// run.
class TrajectoryModel : public QAbstractTableModel {
  Q_OBJECT
public:
  enum Column {
    Time,
    Frame,
    Target,
    X,
    Y,
    Z,
    SigmaX,
    SigmaY,
    SigmaZ,
    Speed,
    Cameras,
    Existence,
    Held,
    ColumnCount
  };
  explicit TrajectoryModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

  const MotionLog& log() const { return log_; }
  void clear();
  /// Replaces the samples from index `first` onward. Returns the first row that has changed.
  std::size_t replaceFrom(std::size_t first, const std::vector<TrajectorySample>& samples);
  /// Returns the rows [first, last) for a range of frames.
  std::pair<int, int> rowsOf(const SelectedRange& selectedRange) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation,
                      int role = Qt::DisplayRole) const override;

private:
  MotionLog log_;
  int rows_ = 0; ///< number of log rows that the views know
};

} // namespace dewpoint::ui
