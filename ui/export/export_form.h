// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/export/trajectory_export.h"

#include <QWidget>

#include <map>
#include <optional>
#include <utility>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QListWidget;

namespace dewpoint::ui {

/// Fields that define ExportOptions: which part of a trajectory is exported, and in which form.
class ExportForm : public QWidget {
  Q_OBJECT
public:
  explicit ExportForm(QWidget* parent = nullptr);

  ExportOptions options() const;
  /// Returns the file name suffix of the selected format, including the dot.
  QString suffix() const;
  /// Returns whether the estimates made during the run are exported. Otherwise, smoothed estimates
  /// are.
  bool exportsLiveEstimates() const;
  /// Lists the targets in a trajectory, and stores the time at which the trajectory ends. If the
  /// list is unchanged, its check marks are kept.
  void setTrajectory(const Trajectory& trajectory);
  /// Proposes to export only this time range (seconds). If `seconds` is empty, the proposal is
  /// withdrawn, unless the user has edited the range.
  void setSelectedRange(std::optional<std::pair<double, double>> seconds);
  /// Resets all choices for another project.
  void resetChoices();
  void retranslateUi();
  /// Return the text and the tooltip of the check box for notes about the run, for all export
  /// dialogs that have such a check box.
  static QString notesText();
  static QString notesHint();

Q_SIGNALS:
  void changed();
  void formatChanged();

protected:
  void showEvent(QShowEvent* event) override;

private:
  void fillChoices();
  /// Names the usual axes and unit of the selected format in their first choices.
  void updateUsualChoices();
  const ExportFormat& format() const;
  /// Shows beside the end of the range how far the run was tracked, if the range goes further.
  void showTrackedEnd();

  QFormLayout* form_;
  std::map<QWidget*, QLabel*> labels_; ///< of the fields
  QComboBox* format_;
  QListWidget* targets_;
  QComboBox* estimates_;
  QDoubleSpinBox* from_;
  QDoubleSpinBox* to_;
  QLabel* trackedTo_;
  QDoubleSpinBox* rate_;
  QComboBox* gaps_;
  QDoubleSpinBox* longestGap_;
  QComboBox* axes_;
  QComboBox* unit_;
  QCheckBox* notes_;
  std::pair<double, double> proposedRange_; ///< proposed range, seconds
  std::optional<double> lastTime_;          ///< of the trajectory, seconds; empty if it is empty
};

} // namespace dewpoint::ui
