// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/export/export_jobs.h"

#include <QDialog>

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QProgressBar;
class QPushButton;
class QTimer;

namespace dewpoint::ui {

class ExportForm;
class ExportOutcome;

/// Exports the trajectory: what, how, and a preview of the file. Not modal: tracking goes on, and
/// the preview follows it. Exports run in the background; signals report the result.
class ExportDialog : public QDialog {
  Q_OBJECT
public:
  /// `trajectory` gives the run so far; called in the window's thread.
  explicit ExportDialog(std::function<Trajectory()> trajectory, QWidget* parent = nullptr);

  /// Takes the run as it is now and shows it.
  void refresh();
  /// Proposes to export these seconds only; nothing: takes that proposal back.
  void setSelectedRange(std::optional<std::pair<double, double>> seconds);
  /// Whether some of the run is of earlier settings: the preview says so.
  void setHasOldResults(bool has);
  /// Proposes a file in this folder.
  void proposeIn(const QString& folder);
  /// Another project: what was chosen for the last one is forgotten; a file in this folder is
  /// proposed.
  void startAnew(const QString& folder);

Q_SIGNALS:
  /// How an export went. While the dialog is shown it says so itself.
  void done(const QString& sentence);
  void failed(const QString& sentence);

protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

private:
  void makeFields();
  void arrangeFields();
  void connectFields();
  void retranslate();
  void changed();
  void formatChanged();
  void askFile();
  void start();
  /// Asks before files are replaced; any change withdraws the question. The export itself finds out
  /// in its thread whether they are there; if something changed before that is known, nothing is
  /// asked, and it is reported that nothing was written.
  void askToReplace(const QString& file);
  void forgetQuestion();
  /// The run goes on: so does the preview.
  void follow();
  void startFigure();
  void setRunning(bool running);
  void stop();
  void endPreview();
  void showPreview(const ExportPreview& preview);
  void showFinished(const ExportSummary& summary);
  /// `file`: what was written.
  void reportDone(const QString& sentence, const QString& file = {});
  void reportFailed(const QString& sentence);
  std::filesystem::path file() const;

  std::function<Trajectory()> trajectorySource_;
  ExportJobs::TrajectoryPtr trajectory_;
  ExportJobs* jobs_;
  QTimer* soon_; ///< several changes in a row make one preview
  QTimer* follow_;
  QTimer* long_; ///< a preview that takes long gets a button to stop it
  ExportForm* form_ = nullptr;
  QPlainTextEdit* preview_;
  QLabel* units_;
  QLabel* size_;
  QLabel* old_;
  QLabel* question_;
  ExportOutcome* outcome_;
  QLineEdit* file_;
  QPushButton* browse_;
  QProgressBar* progress_;
  QPushButton* cancel_;
  QPushButton* figure_;
  QPushButton* export_;
  QPushButton* close_;
  bool running_ = false;
  bool previewing_ = false;
  bool mayReplace_ = false; ///< the question was shown, and nothing changed since
  int questions_ = 0;       ///< grows with every change that takes a question back
  int startedAt_ = 0;       ///< questions_ when the export under way began
};

} // namespace dewpoint::ui
