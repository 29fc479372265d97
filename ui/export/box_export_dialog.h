// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/box_track_file.h"

#include <QDialog>

#include <filesystem>
#include <functional>

class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;

namespace dewpoint::ui {

class BackgroundJob;

/// Exports the boxes of a run: boxes.csv and boxes_mot.txt into a folder. Not modal; files are
/// written in the background.
class BoxExportDialog : public QDialog {
  Q_OBJECT
public:
  /// `boxes` gives the run so far; called in the window's thread.
  explicit BoxExportDialog(std::function<BoxTrack()> boxes, QWidget* parent = nullptr);

  /// Proposes this folder.
  void proposeIn(const QString& folder);

Q_SIGNALS:
  void done(const QString& sentence);
  void failed(const QString& sentence);

protected:
  void showEvent(QShowEvent* event) override;

private:
  void retranslateUi();
  void chooseFolder();
  void start();
  void askToReplace(bool ask);
  /// The folder has a file of this name already: asks whether to replace it. When nobody sees the
  /// question, or another folder was chosen meanwhile, reports that nothing was written.
  void askAbout(const std::filesystem::path& folder, const char* name);
  std::filesystem::path chosenFolder() const;

  std::function<BoxTrack()> boxes_;
  BackgroundJob* job_;
  QLabel* sentence_;
  QPlainTextEdit* preview_;
  QLabel* folderLabel_;
  QLineEdit* folder_;
  QPushButton* browse_;
  QPushButton* close_;
  QPushButton* export_;
  QLabel* question_;
  bool mayReplace_ = false; ///< the question was shown, and nothing changed since
};

} // namespace dewpoint::ui
