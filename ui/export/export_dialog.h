// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/export/export_destination.h"
#include "ui/export/export_jobs.h"

#include <QDialog>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTimer;

namespace dewpoint::ui {

class ExportForm;
class ExportOutcome;
class PreviewPane;

/// Exports the trajectory. The user selects content and format, and a preview shows the file. Not
/// modal: tracking continues, and the preview is updated. Exports run in the background; signals
/// report the result.
class ExportDialog : public QDialog {
  Q_OBJECT
public:
  /// Creates the dialog. `trajectory` returns the trajectory of the run so far; it is called in the
  /// GUI thread.
  explicit ExportDialog(std::function<Trajectory()> trajectory, QWidget* parent = nullptr);

  /// Reads the current trajectory of the run, and updates the dialog.
  void refresh();
  /// Proposes to export only this time range (seconds). If `seconds` is empty, the proposal is
  /// withdrawn.
  void setSelectedRange(std::optional<std::pair<double, double>> seconds);
  /// Sets whether part of the run has results from earlier settings. If so, the preview shows a
  /// warning.
  void setResultsOutdated(bool outdated);
  /// Proposes a file, without its suffix, unless the user has entered another one.
  void proposeFile(const QString& file);
  /// Resets all choices for another project, and proposes a file.
  void resetChoices(const QString& file);

Q_SIGNALS:
  /// Emitted with the result of an export. While the dialog is visible, the dialog also shows this
  /// result.
  void completed(const QString& sentence);
  void failed(const QString& sentence);
  /// Emitted when an export has written this file.
  void fileWritten(const QString& file);

protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  void makeFields();
  void arrangeFields();
  void connectFields();
  void retranslateUi();
  void changed();
  void formatChanged();
  void chooseFile();
  void start();
  /// Asks the user before existing files are replaced. Any change of the choices withdraws the
  /// question. Another thread checks whether the files exist. If the choices change before this
  /// check ends, the question is not shown, and the dialog reports that nothing was written.
  void askToReplace(const QString& file);
  void withdrawQuestion();
  /// Updates the preview while the run continues.
  void updatePreview();
  void startFigure();
  void setRunning(bool running);
  void stop();
  void showFinished(const ExportSummary& summary);
  /// Reports the result. `file` is the file that was written.
  void reportDone(const QString& sentence, const QString& file = {});
  void reportFailed(const QString& sentence);
  std::filesystem::path file() const;

  std::function<Trajectory()> trajectorySource_;
  ExportJobs::TrajectoryPtr trajectory_;
  ExportJobs* jobs_;
  QTimer* previewTimer_;
  ExportForm* form_ = nullptr;
  PreviewPane* preview_;
  QLabel* question_;
  ExportOutcome* outcome_;
  QLineEdit* file_;
  std::optional<ProposedFile> proposed_; ///< of `file_`
  QPushButton* browse_;
  QProgressBar* progress_;
  QPushButton* cancel_;
  QPushButton* figure_;
  QPushButton* export_;
  QPushButton* close_;
  bool running_ = false;
  bool mayReplace_ = false; ///< the question was shown and nothing has changed since
  int questions_ = 0;       ///< incremented by every change that withdraws a question
  int startedAt_ = 0;       ///< value of `questions_` when the current export began
};

} // namespace dewpoint::ui
