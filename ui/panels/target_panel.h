// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

class QAction;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QListView;
class QToolButton;
class QVBoxLayout;

namespace dewpoint::project {
struct Project;
} // namespace dewpoint::project
namespace dewpoint::session {
struct TrackSnapshot;
} // namespace dewpoint::session

namespace dewpoint::ui {

class Document;
class HistogramView;
class TargetListModel;
class TargetRowDelegate;
using TrackSnapshotPtr = std::shared_ptr<const TrackSnapshot>;

/// What is followed: the targets by name, each with its color, its state and its size, and the name
/// and size of the chosen one.
class TargetPanel : public QWidget {
  Q_OBJECT
public:
  TargetPanel(Document& document, TargetListModel& targets, QWidget* parent = nullptr);

  /// Puts buttons for these actions above the list.
  void addTools(QAction* add, QAction* remove, QAction* learn);

  /// Index of the chosen target; -1 without targets.
  int chosen() const;
  /// Chooses a target of the list; others change nothing.
  void choose(int target);
  /// The states of the targets in the frame shown, and what is believed of the chosen one's box, if
  /// its method follows boxes.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Takes the chosen target out, as an undoable step.
  void removeChosen();

Q_SIGNALS:
  void targetChosen(int target);

private:
  void makeFields(TargetListModel& targets);
  void retranslateUi();
  void refresh();
  void showRows();
  void showBox();
  void showChosen();
  void editChosen(const QString& step, const std::function<void(Project&, std::size_t)>& change);
  void rename();
  void resizeTarget(double millimeters);
  void reshapeTarget(int shape);

  Document& document_;
  QListView* list_;
  TargetRowDelegate* rows_;
  QVBoxLayout* column_ = nullptr;
  QToolButton* add_ = nullptr; ///< null before addTools(), as the others
  QToolButton* remove_ = nullptr;
  QToolButton* learn_ = nullptr;
  QLabel* nameLabel_;
  QLineEdit* name_;
  QLabel* radiusLabel_;
  QDoubleSpinBox* radius_;
  QLabel* shapeLabel_;
  QComboBox* shape_; ///< its items are in the order of TargetShape
  QLabel* box_;      ///< numbers of the box
  HistogramView* histograms_;
  QLabel* hint_;
  TrackSnapshotPtr snapshot_;
  int shown_ = -1; ///< row that was chosen at the last refresh
  bool refreshing_ = false;
};

} // namespace dewpoint::ui
