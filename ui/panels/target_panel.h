// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/target_speed.h"

#include <QString>
#include <QWidget>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

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

/// Panel of the targets: a list by name, each target with its color, state and size, and fields for
/// the selected target.
class TargetPanel : public QWidget {
  Q_OBJECT
public:
  TargetPanel(Document& document, TargetListModel& targets, QWidget* parent = nullptr);

  /// Adds buttons for the actions that add, remove and learn a target above the list.
  void addTools(QAction* add, QAction* remove, QAction* learn);

  /// Returns the index of the selected target, or -1 without targets.
  int chosenTarget() const;
  /// Selects a target in the list. Invalid indices are ignored.
  void chooseTarget(int target);
  /// Sets the snapshot shown, which provides the target states and, for methods that track boxes,
  /// the estimated box of the selected target.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Removes the selected target in an undoable step.
  void removeChosenTarget();
  /// Hides a target in the views, or shows it again, in an undoable step. Invalid rows are ignored.
  void toggleTargetShown(int row);

Q_SIGNALS:
  void targetChosen(int target);

protected:
  void changeEvent(QEvent* event) override;

private:
  void makeFields(TargetListModel& targets);
  void retranslateUi();
  void refresh();
  void showRows();
  /// Updates the speeds of the targets with the frame shown.
  void addSpeeds();
  /// Returns the speed of a target that is tracked in the frame shown; empty if it is unknown.
  QString speedTextOf(std::size_t target) const;
  void showBox();
  void showChosen();
  /// Returns the hint about what to do for the target in this row; empty if nothing is to be done.
  QString hintOf(int row) const;
  void editChosen(const QString& step, const std::function<void(Project&, std::size_t)>& change);
  void rename();
  void resizeTarget(double millimeters);
  void reshapeTarget(int shape);

  Document& document_;
  QListView* list_;
  TargetRowDelegate* rows_;
  QVBoxLayout* column_ = nullptr;
  QToolButton* add_ = nullptr; ///< null before addTools(), as are the other two
  QToolButton* remove_ = nullptr;
  QToolButton* learn_ = nullptr;
  QLabel* nameLabel_;
  QLineEdit* name_;
  QLabel* radiusLabel_;
  QDoubleSpinBox* radius_;
  QLabel* shapeLabel_;
  QComboBox* shape_; ///< items in the order of TargetShape
  QLabel* box_;      ///< coordinates of the bounding box
  HistogramView* histograms_;
  QLabel* hint_;
  TrackSnapshotPtr snapshot_;
  std::vector<TargetSpeed> speeds_; ///< of the first targets
  int shown_ = -1;                  ///< row selected at the last refresh
  bool refreshing_ = false;
};

} // namespace dewpoint::ui
