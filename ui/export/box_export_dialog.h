// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/box_track_file.h"

#include <QDialog>

#include <filesystem>
#include <functional>

class QCheckBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;

namespace dewpoint::ui {

class BackgroundJob;

/// Exports a run's bounding boxes to a folder: boxes.csv and boxes_mot.txt. Not modal; the files
/// are written in the background.
class BoxExportDialog : public QDialog {
  Q_OBJECT
public:
  /// Creates the dialog. `boxes` returns the bounding boxes of the run so far; it is called in the
  /// GUI thread.
  explicit BoxExportDialog(std::function<BoxTrack()> boxes, QWidget* parent = nullptr);

  /// Proposes a folder, unless the user has entered another one.
  void proposeFolder(const QString& folder);
  /// Proposes a folder, even if the user has entered another one.
  void resetFolder(const QString& folder);

Q_SIGNALS:
  void completed(const QString& sentence);
  void failed(const QString& sentence);
  /// Emitted when both files were written, with the path of one of them.
  void fileWritten(const QString& file);

protected:
  void showEvent(QShowEvent* event) override;

private:
  void retranslateUi();
  void showFirstLines();
  void chooseFolder();
  void start();
  void askToReplace(bool ask);
  /// Asks whether to replace the existing file `name` in the folder. If the dialog is not visible,
  /// or another folder has been selected, it does not ask, and reports that nothing was written.
  void askAbout(const std::filesystem::path& folder, const char* name);
  std::filesystem::path chosenFolder() const;
  CsvNotes chosenNotes() const;

  std::function<BoxTrack()> boxes_;
  BackgroundJob* job_;
  QLabel* description_;
  QPlainTextEdit* preview_;
  QCheckBox* notes_;
  QLabel* folderLabel_;
  QLineEdit* folder_;
  QPushButton* browse_;
  QPushButton* close_;
  QPushButton* export_;
  QLabel* question_;
  QString proposed_;        ///< last folder that was proposed
  bool mayReplace_ = false; ///< the question was shown and nothing has changed since
};

} // namespace dewpoint::ui
