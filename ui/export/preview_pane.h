// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/export/export_jobs.h"

#include <QWidget>

#include <functional>

class QLabel;
class QPlainTextEdit;
class QTimer;

namespace dewpoint::ui {

/// The first lines of the file that an export would write, with its units and size. Made in the
/// background, a little after what it depends on has changed.
class PreviewPane : public QWidget {
  Q_OBJECT
public:
  /// `order`: orders a preview of what is chosen from the jobs.
  PreviewPane(ExportJobs& jobs, std::function<void()> order, QWidget* parent = nullptr);

  /// Several requests in a row make one preview.
  void request();
  /// Whether a preview is requested or under way.
  bool isBusy() const;
  /// Nobody looks at it any more.
  void abandon();
  /// Somebody waits no longer: says so in place of the preview.
  void stop();
  /// Ends the current preview when an export begins, and makes it again when the export is over.
  void setExporting(bool exporting);
  /// A request is dropped; what is under way goes on.
  void dropRequest();
  /// Whether some of the run is of earlier settings: it says so.
  void setHasOldResults(bool has);
  void retranslateUi();

Q_SIGNALS:
  /// It takes long: there should be a way to stop it.
  void takesLong();
  /// No preview is under way any more.
  void ended();

private:
  void connectJobs();
  void showPreview(const ExportPreview& preview);
  void end();

  ExportJobs& jobs_;
  QLabel* units_;
  QLabel* size_;
  QLabel* old_;
  QPlainTextEdit* lines_;
  QTimer* soon_;
  QTimer* long_;
  bool isUnderWay_ = false;
};

} // namespace dewpoint::ui
