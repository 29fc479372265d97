// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/session.h"

#include <QTimer>
#include <QWidget>

#include <functional>

class QLabel;
class QTableView;

namespace dewpoint::session {
struct TrackSnapshot;
} // namespace dewpoint::session

namespace dewpoint::ui {

class BoxModel;
class Selection;
class FrameRowDelegate;

/// Panel with the bounding boxes of a run whose method tracks boxes, in a table that follows the
/// frame shown.
class BoxPanel : public QWidget {
  Q_OBJECT
public:
  /// Function that returns the boxes added since `position`, and updates both arguments, as
  /// Session::boxesSince() of the session to follow does.
  using Source =
      std::function<LogUpdate<BoxSample>(std::uint64_t& generation, std::size_t& position)>;

  explicit BoxPanel(Selection& selection, QWidget* parent = nullptr);

  /// Sets the source of the boxes. An empty function means no source.
  void setSource(Source source);
  /// Schedules fetching new boxes. They are fetched only while the panel is visible.
  void refresh();
  /// Sets the newest snapshot, which provides the target names.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Returns the selected rows, or all rows if none are selected, in the format of boxes.csv.
  QByteArray csv();

Q_SIGNALS:
  void contextMenuRequested(const QPoint& place);

protected:
  void showEvent(QShowEvent* event) override;

private:
  void fetch();
  void updateSummary();

  BoxModel* model_;
  QTableView* table_;
  FrameRowDelegate* head_ = nullptr;
  QLabel* summary_;
  Source source_;
  std::uint64_t generation_ = 0;
  std::size_t position_ = 0;
  QTimer timer_;
};

} // namespace dewpoint::ui
