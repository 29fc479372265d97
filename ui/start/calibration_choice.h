// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration_check.h"
#include "ui/jobs/latest_job.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <string>
#include <vector>

class QLabel;
class QPushButton;

namespace dewpoint::ui {

/// The calibration file of a new project, or none. It is read in a thread as soon as it is chosen,
/// and a line below says what it is, or why it cannot be used.
class CalibrationChoice : public QWidget {
  Q_OBJECT
public:
  explicit CalibrationChoice(QWidget* parent = nullptr);

  /// Empty: none.
  void setFile(const QString& file);
  QString file() const { return file_; }
  /// What the cameras of the project are called.
  void setCameras(std::vector<std::string> names);
  /// The last of its buttons in the order of the Tab key.
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
  std::optional<CheckedCalibration> checked_; ///< of the file; nothing: it is being read
  LatestJob checking_{LatestJob::Overtaken::Dropped};
};

} // namespace dewpoint::ui
