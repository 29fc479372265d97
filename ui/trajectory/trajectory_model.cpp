// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trajectory/trajectory_model.h"

#include "ui/plots/plot_declaration.h"
#include "ui/text/quantity_text.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::ui {

void TrajectoryModel::clear() {
  beginResetModel();
  log_.clear();
  rows_ = 0;
  endResetModel();
}

std::size_t TrajectoryModel::replaceFrom(std::size_t first,
                                         const std::vector<TrajectorySample>& samples) {
  const MotionLog::Change change = log_.replaceFrom(first, samples);
  const int now = static_cast<int>(log_.rows().size());
  if (change.droppedRowCount > 0 || now < rows_) {
    beginResetModel();
    rows_ = now;
    endResetModel();
    return 0;
  }
  const int before = rows_;
  if (now > before) {
    beginInsertRows({}, before, now - 1);
    rows_ = now;
    endInsertRows();
  }
  if (const int changed = static_cast<int>(change.firstChangedRow); changed < before) {
    Q_EMIT dataChanged(index(changed, 0), index(before - 1, ColumnCount - 1));
  }
  return change.firstChangedRow;
}

std::pair<int, int> TrajectoryModel::rowsOf(const SelectedRange& selectedRange) const {
  const auto frameOf = [](const MotionLog::Row& row) { return row.sample.frame; };
  const auto& rows = log_.rows();
  const auto first = std::ranges::lower_bound(rows, selectedRange.first, {}, frameOf);
  const auto last = std::ranges::upper_bound(rows, selectedRange.last, {}, frameOf);
  return {static_cast<int>(first - rows.begin()), static_cast<int>(last - rows.begin())};
}

int TrajectoryModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : rows_;
}

int TrajectoryModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant TrajectoryModel::data(const QModelIndex& index, int role) const {
  if (role == Qt::TextAlignmentRole) {
    const bool words = index.column() == Target || index.column() == Held;
    return static_cast<int>((words ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole || index.row() >= rowCount()) {
    return {};
  }
  const MotionLog::Row& row = log_.rows()[static_cast<std::size_t>(index.row())];
  const TrajectorySample& sample = row.sample;
  switch (index.column()) {
  case Time:
    return tableNumberText(sample.time, 3);
  case Frame:
    return frameNumberText(sample.frame);
  case Target:
    return QString::fromStdString(sample.target);
  case X:
  case Y:
  case Z:
    return lengthNumber(sample.position[index.column() - X], LengthScale::Meters, 4,
                        NumberForm::Table);
  case SigmaX:
  case SigmaY:
  case SigmaZ:
    return lengthNumber(positionSigma(sample, index.column() - SigmaX), LengthScale::Millimeters, 1,
                        NumberForm::Table);
  case Speed:
    return tableNumberText(row.speed, 2);
  case Cameras:
    return QString::number(sample.cameraCount);
  case Existence:
    return tableNumberText(sample.existenceProbability, 2);
  case Held:
    return sample.isCorrected   ? tr("◆ corrected")
           : sample.isAmbiguous ? tr("◇ ambiguous")
           : sample.isValid     ? tr("● tracking")
                                : tr("○ not tracked");
  default:
    return {};
  }
}

QVariant TrajectoryModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || (role != Qt::DisplayRole && role != Qt::ToolTipRole)) {
    return {};
  }
  const bool name = role == Qt::DisplayRole;
  switch (section) {
  case Time:
    return name ? tr("time, s") : tr("Time of the frame, in seconds");
  case Frame:
    return name ? tr("frame") : tr("Frame, counted from 1");
  case Target:
    return name ? tr("target") : tr("Name of the target");
  case X:
  case Y:
  case Z: {
    const QChar axis("xyz"[section - X]);
    return name ? tr("%1, m").arg(axis) : tr("Position in the room, in meters");
  }
  case SigmaX:
  case SigmaY:
  case SigmaZ: {
    const QChar axis("xyz"[section - SigmaX]);
    return name ? tr("σ%1, mm").arg(axis)
                : tr("Standard deviation of the position, in millimeters");
  }
  case Speed:
    return name ? tr("speed, m/s") : tr("Speed in meters per second, computed from five frames");
  case Cameras:
    return name ? tr("cameras") : tr("Number of cameras that see the target");
  case Existence:
    return name ? tr("existence")
                : tr("Existence probability: how likely it is that the target is there and "
                     "tracked, 0 to 1");
  case Held:
    return name ? tr("state")
                : tr("Tracking: the cameras confirm the estimate. Ambiguous: another object fits "
                     "about "
                     "as well. Corrected: you set the position");
  default:
    return {};
  }
}

} // namespace dewpoint::ui
