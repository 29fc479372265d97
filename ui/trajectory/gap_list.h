// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/motion.h"
#include "ui/selection/selection.h"

#include <QTableWidget>

#include <optional>
#include <vector>

namespace dewpoint::ui {

/// List of the gaps in a trajectory (frames without a position), with start, end and length. It
/// contains the newest kMaxGaps gaps.
class GapList : public QTableWidget {
  Q_OBJECT
public:
  static constexpr int kMaxGaps = 500;
  explicit GapList(QWidget* parent = nullptr);

  void setGaps(std::vector<TrajectoryGap> gaps);
  /// Highlights the gap whose frames are exactly this range, if there is one.
  void setSelectedRange(std::optional<SelectedRange> selectedRange);

Q_SIGNALS:
  void gapChosen(qint64 first, qint64 last);

protected:
  void changeEvent(QEvent* event) override;

private:
  void fill();
  void widen();

  std::vector<TrajectoryGap> gaps_;
};

} // namespace dewpoint::ui
