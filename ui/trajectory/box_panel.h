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
class TableHead;

/// The boxes of a run whose method follows boxes in images: a table that follows the frame shown.
class BoxPanel : public QWidget {
  Q_OBJECT
public:
  /// Session::boxesSince() of the session followed.
  using Source =
      std::function<Session::BoxesPiece(std::uint64_t& generation, std::size_t& position)>;

  explicit BoxPanel(Selection& selection, QWidget* parent = nullptr);

  /// What is followed; an empty function: nothing.
  void follow(Source source);
  /// There may be new boxes: fetches them soon, and only while the panel is visible.
  void refresh();
  /// The newest snapshot: what the targets are called.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// The rows selected, or all, as in boxes.csv.
  QByteArray csv();

Q_SIGNALS:
  void contextMenuWanted(const QPoint& place);

protected:
  void showEvent(QShowEvent* event) override;

private:
  void fetch();
  void updateSummary();

  BoxModel* model_;
  QTableView* table_;
  TableHead* head_ = nullptr;
  QLabel* summary_;
  Source source_;
  std::uint64_t generation_ = 0;
  std::size_t position_ = 0;
  QTimer timer_;
};

} // namespace dewpoint::ui
