// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trajectory/box_model.h"

#include "ui/text/quantity_text.h"

#include <algorithm>

namespace dewpoint::ui {

void BoxModel::replaceFrom(std::size_t first, const std::vector<BoxSample>& samples) {
  const std::size_t kept = std::min(first, samples_.size());
  const std::size_t before = samples_.size();
  const std::size_t now = kept + samples.size();
  if (now < before) {
    beginResetModel();
  } else if (now > before) {
    beginInsertRows({}, static_cast<int>(before), static_cast<int>(now) - 1);
  }
  samples_.resize(kept);
  samples_.insert(samples_.end(), samples.begin(), samples.end());
  if (now < before) {
    endResetModel();
    return;
  }
  if (now > before) {
    endInsertRows();
  }
  if (kept < before) {
    Q_EMIT dataChanged(index(static_cast<int>(kept), 0),
                       index(static_cast<int>(before) - 1, ColumnCount - 1));
  }
}

void BoxModel::setTargetNames(const QStringList& names) {
  if (names != names_) {
    names_ = names;
    if (!samples_.empty()) {
      Q_EMIT dataChanged(index(0, Target), index(rowCount() - 1, Target));
    }
  }
}

int BoxModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(samples_.size());
}

int BoxModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant BoxModel::data(const QModelIndex& index, int role) const {
  if (role == Qt::TextAlignmentRole) {
    const bool words = index.column() == Target || index.column() == Seen;
    return static_cast<int>((words ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole || index.row() >= rowCount()) {
    return {};
  }
  const BoxSample& sample = samples_[static_cast<std::size_t>(index.row())];
  const BoxEstimate& estimate = sample.estimate;
  switch (index.column()) {
  case Time:
    return tableNumberText(sample.time, 3);
  case Frame:
    return frameNumberText(sample.frame);
  case Target:
    return names_.value(sample.target - 1, QString::number(sample.target));
  case X:
    return tableNumberText(estimate.box.center().x(), 1);
  case Y:
    return tableNumberText(estimate.box.center().y(), 1);
  case Width:
    return tableNumberText(estimate.box.width, 1);
  case Height:
    return tableNumberText(estimate.box.height, 1);
  case Similarity:
    return tableNumberText(estimate.similarity, 2);
  case Spread:
    return tableNumberText(estimate.spreadPixels, 1);
  case Seen:
    return estimate.isVisible ? tr("● tracking") : tr("◌ hidden");
  default:
    return {};
  }
}

QVariant BoxModel::headerData(int section, Qt::Orientation orientation, int role) const {
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
    return name ? tr("x, px") : tr("Center of the box, pixels from the left edge of the image");
  case Y:
    return name ? tr("y, px") : tr("Center of the box, pixels from the upper edge of the image");
  case Width:
    return name ? tr("width, px") : tr("Box width (pixels)");
  case Height:
    return name ? tr("height, px") : tr("Box height (pixels)");
  case Similarity:
    return name ? tr("similarity")
                : tr("Similarity of the colors in the box to the initial colors, 0 to 1");
  case Spread:
    return name ? tr("spread, px")
                : tr("Root mean square distance of the particles from their mean");
  case Seen:
    return name ? tr("state")
                : tr("Hidden: the target was not found in this frame; the box shows where it is "
                     "expected");
  default:
    return {};
  }
}

} // namespace dewpoint::ui
