// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/calibration_check.h"
#include "ui/jobs/latest_job.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <string>
#include <vector>

class QLabel;
class QPushButton;

namespace dewpoint::ui {

/// Selects the calibration file of a new project, or none. The file is read in another thread as
/// soon as it is selected; a line below shows what it contains, or why it cannot be used.
class CalibrationChoice : public QWidget {
  Q_OBJECT
public:
  explicit CalibrationChoice(QWidget* parent = nullptr);

  /// Sets the file; empty: none.
  void setFile(const QString& file);
  QString file() const { return file_; }
  /// Sets the names of the cameras of the project.
  void setCameras(std::vector<std::string> names);
  /// Last button in the order of the Tab key.
  QWidget* lastButton() const;

protected:
  void changeEvent(QEvent* event) override;

private:
  void choose();
  void retranslateUi();
  void showResult();
  QString resultText(const CheckedCalibration& checked, bool& good) const;

  QLabel* label_;
  QLabel* name_;
  QPushButton* drop_;
  QPushButton* choose_;
  QLabel* result_;
  QString file_;
  std::vector<std::string> cameras_;
  std::optional<CheckedCalibration> checked_; ///< result for the file; empty: it is being read
  LatestJob checking_{LatestJob::Overtaken::Dropped};
};

} // namespace dewpoint::ui
