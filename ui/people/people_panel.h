// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"

#include <QElapsedTimer>
#include <QWidget>

class QAction;
class QLabel;
class QProgressBar;
class QTableWidget;
class QToolButton;

namespace dewpoint::ui {

class Selection;

/// Table of the people present, one row per person, in the identity color. Above the table, the
/// panel shows the progress while the cameras learn the background. Selecting a row selects the
/// person in all views.
class PeoplePanel : public QWidget {
  Q_OBJECT
public:
  /// Creates the panel. `place` and `remove` are the actions of the buttons below the table.
  PeoplePanel(Selection& selection, QAction* place, QAction* remove, QWidget* parent = nullptr);

  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Returns the identity of the selected person, or 0 if none is selected.
  int chosenPerson() const;

  QSize minimumSizeHint() const override { return {200, 160}; }

private:
  void retranslateUi();
  void refresh();
  void showLearning();
  void showRow(int row, const TargetSnapshot& target, const PersonEstimate& person);
  void setCell(int row, int column, const QString& text, const QString& hint = {});
  void selectRow(int target);
  void makeTable();

  Selection& selection_;
  QLabel* summary_;
  QProgressBar* learning_;
  QTableWidget* table_;
  QToolButton* place_;
  QToolButton* remove_;
  TrackSnapshotPtr snapshot_;
  QElapsedTimer sinceRefresh_;
  bool following_ = false; ///< true while the table adopts the selection
};

} // namespace dewpoint::ui
