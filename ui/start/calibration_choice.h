// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/calibration_check.h"
#include "core/setup/new_project/new_project.h"
#include "ui/jobs/latest_job.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <string>
#include <vector>

class QLabel;
class QPushButton;

namespace dewpoint::ui {

class CalibrationFit;

/// Lets the user select the calibration file for a new project, or none. The file is read in
/// another thread as soon as it is selected. A line of text shows what the file contains, or why it
/// cannot be used.
class CalibrationChoice : public QWidget {
  Q_OBJECT
public:
  explicit CalibrationChoice(QWidget* parent = nullptr);

  /// Starts a new project, for which no file is selected yet. `acceptsProposals` is true if a
  /// calibration file found beside the recordings may be selected (proposeFile()).
  void startNewProject(bool acceptsProposals);
  /// Sets the file that the user has chosen; an empty name means that the user wants none. From
  /// then on, a file found beside the recordings (proposeFile()) is ignored.
  void setFile(const QString& file);
  /// Selects a file that was found beside the recordings; an empty name means that none was found.
  /// Does nothing if the user has chosen, or if such files are not wanted for this project
  /// (acceptsProposals()).
  void proposeFile(const QString& file);
  bool acceptsProposals() const { return acceptsProposals_; }
  QString file() const { return file_; }
  /// Sets the names of the project's cameras.
  void setCameraNames(std::vector<std::string> names);
  /// Returns the user's answers about how to adapt the calibration to the cameras.
  CalibrationAdaptation adaptation() const;
  /// Returns whether the user is asked which camera of the file belongs to which camera of the
  /// project.
  bool isNameQuestionShown() const;
  /// Shows the question how the images differ from those of the calibration.
  void showImageChangeQuestion();
  /// Returns the last button in Tab order.
  QWidget* lastButtonInTabOrder() const;

protected:
  void changeEvent(QEvent* event) override;

private:
  void choose();
  void useFile(const QString& file);
  void retranslateUi();
  void showResult();
  QString resultText(const CheckedCalibration& checked, bool& good) const;

  QLabel* label_;
  QLabel* name_;
  QPushButton* drop_;
  QPushButton* choose_;
  QLabel* result_;
  CalibrationFit* fit_;
  QString file_;
  bool acceptsProposals_ = true; ///< the user has chosen nothing; a selected file was proposed
  std::vector<std::string> cameras_;
  std::optional<CheckedCalibration> checked_; ///< result for the file; empty while it is being read
  LatestJob checking_{LatestJob::SupersededJob::Dropped};
};

} // namespace dewpoint::ui
