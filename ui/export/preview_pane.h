// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/export/export_jobs.h"

#include <QWidget>

#include <functional>

class QLabel;
class QPlainTextEdit;
class QTimer;

namespace dewpoint::ui {

/// Pane that shows the first lines of the file that an export would write, with its units and size.
/// It is scrolled past the notes, so that the column names and the first rows are visible. The
/// preview is computed in the background, a short time after its input has changed.
class PreviewPane : public QWidget {
  Q_OBJECT
public:
  /// Creates the pane. `order` must request a preview of the current choices from `jobs`.
  PreviewPane(ExportJobs& jobs, std::function<void()> order, QWidget* parent = nullptr);

  /// Requests a preview. Several requests in quick succession produce one preview.
  void requestPreview();
  /// Returns whether a preview is requested or in progress.
  bool isBusy() const;
  /// Cancels the preview. Call this when the pane is no longer visible.
  void cancelPreview();
  /// Cancels the preview on the user's request and shows a note in its place.
  void stopOnUserRequest();
  /// Cancels the current preview when an export begins (`exporting` is true), and requests the
  /// preview again when the export is over (false).
  void setExporting(bool exporting);
  /// Drops a pending request for a preview. A preview in progress continues.
  void cancelPendingRequest();
  /// Sets whether part of the run has results from earlier settings. If so, the pane shows a note.
  void setResultsOutdated(bool outdated);
  void retranslateUi();

Q_SIGNALS:
  /// Emitted when a preview takes long, so that the user can be offered a way to stop it.
  void previewTakesLong();
  /// Emitted when no preview is in progress anymore.
  void previewEnded();

private:
  void connectJobs();
  void showPreview(const ExportPreview& preview);
  void clearLines();
  void end();

  ExportJobs& jobs_;
  QLabel* units_;
  QLabel* size_;
  QLabel* old_;
  QPlainTextEdit* lines_;
  QTimer* startTimer_;
  QTimer* longTimer_;
  bool isUnderWay_ = false;
  int noteLines_ = -1; ///< of the preview shown; -1: none is shown
};

} // namespace dewpoint::ui
