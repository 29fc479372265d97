// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QListWidget;

namespace dewpoint::project {
struct Project;
} // namespace dewpoint::project
namespace dewpoint::session {
struct TrackSnapshot;
} // namespace dewpoint::session

namespace dewpoint::ui {

class Document;
using TrackSnapshotPtr = std::shared_ptr<const TrackSnapshot>;

/// What is followed: the targets by name, and the name and size of the chosen one.
class TargetPanel : public QWidget {
  Q_OBJECT
public:
  explicit TargetPanel(Document& document, QWidget* parent = nullptr);

  /// Index of the chosen target; -1 without targets.
  int chosen() const;
  void choose(int target);
  /// What is believed of the chosen target's box at the moment shown, if its method follows boxes.
  void setSnapshot(const TrackSnapshotPtr& snapshot);
  /// Takes the chosen target out, as an undoable step.
  void removeChosen();

Q_SIGNALS:
  void targetChosen(int target);

private:
  void refresh();
  void showChosen();
  void editChosen(const QString& step, const std::function<void(Project&, std::size_t)>& change);
  void rename();
  void resizeTarget(double millimetres);

  Document& document_;
  QListWidget* list_;
  QLabel* nameLabel_;
  QLineEdit* name_;
  QLabel* radiusLabel_;
  QDoubleSpinBox* radius_;
  QLabel* box_; ///< figures of the box
  QLabel* hint_;
};

} // namespace dewpoint::ui
