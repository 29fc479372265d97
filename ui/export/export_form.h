// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/trajectory/export/trajectory_export.h"

#include <QWidget>

#include <optional>
#include <utility>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QListWidget;

namespace dewpoint::ui {

/// What of a trajectory is exported and how: the fields that make ExportOptions.
class ExportForm : public QWidget {
  Q_OBJECT
public:
  explicit ExportForm(QWidget* parent = nullptr);

  ExportOptions options() const;
  /// The ending of files in the chosen format, with its dot.
  QString suffix() const;
  /// Whether the estimates are those known live.
  bool isLive() const;
  /// Offers the targets of a trajectory; the same ones stay as they are marked.
  void setTargetsOf(const Trajectory& trajectory);
  /// Proposes these seconds only; nothing: takes that proposal back, if nobody typed since.
  void setSelectedRange(std::optional<std::pair<double, double>> seconds);
  /// Forgets what was chosen for another project.
  void startAnew();
  void retranslate();

Q_SIGNALS:
  void changed();
  void formatChanged();

private:
  void fillChoices();

  QFormLayout* form_;
  QComboBox* format_;
  QListWidget* targets_;
  QComboBox* estimates_;
  QDoubleSpinBox* from_;
  QDoubleSpinBox* to_;
  QDoubleSpinBox* rate_;
  QComboBox* gaps_;
  QDoubleSpinBox* longestGap_;
  QComboBox* axes_;
  QComboBox* unit_;
  QCheckBox* header_;
  std::pair<double, double> given_; ///< the range that was proposed
};

} // namespace dewpoint::ui
