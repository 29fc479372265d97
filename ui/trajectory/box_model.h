// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/box_track_file.h"

#include <QAbstractTableModel>
#include <QStringList>

#include <vector>

namespace dewpoint::ui {

/// Table model of a run's bounding boxes, in pixels, with one row per target and frame. The table
/// grows with the run.
class BoxModel : public QAbstractTableModel {
  Q_OBJECT
public:
  enum Column { Time, Frame, Target, X, Y, Width, Height, Similarity, Spread, Seen, ColumnCount };
  explicit BoxModel(QObject* parent = nullptr) : QAbstractTableModel(parent) {}

  const std::vector<BoxSample>& samples() const { return samples_; }
  void clear() { replaceFrom(0, {}); }
  /// Replaces all samples from index `first` on by `samples`.
  void replaceFrom(std::size_t first, const std::vector<BoxSample>& samples);
  /// Sets the target names, in target order.
  void setTargetNames(const QStringList& names);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation,
                      int role = Qt::DisplayRole) const override;

private:
  std::vector<BoxSample> samples_;
  QStringList names_;
};

} // namespace dewpoint::ui
