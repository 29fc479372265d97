// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QDialog>
#include <QString>

#include <vector>

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace dewpoint::experiment {
struct FigureExperiment;
} // namespace dewpoint::experiment

namespace dewpoint::ui {

class BackgroundJob;

/// Dialog that reproduces figures from the papers and runs further studies. The user selects a
/// study, follows its progress, and opens its report. The computation runs in another thread.
class ExperimentDialog : public QDialog {
  Q_OBJECT
public:
  explicit ExperimentDialog(QWidget* parent = nullptr);

Q_SIGNALS:
  void failed(const QString& sentence);

private:
  void makeFields();
  void fillList();
  void showRunning(bool running);
  void retranslateUi();
  const FigureExperiment& chosen() const;
  void showChosen();
  void chooseFolder(QLineEdit* into, const QString& title);
  void run();
  void finish(const QString& report);
  void openReport();

  /// List rows; null for a heading of the rows below it.
  std::vector<const FigureExperiment*> rows_;
  BackgroundJob* job_;
  QListWidget* list_;
  QLabel* description_;
  QLabel* runsLabel_;
  QSpinBox* runs_;
  QLabel* clothesLabel_;
  QComboBox* clothes_; ///< clothing of simulated people
  QLabel* recordingsLabel_;
  QLineEdit* recordings_;
  QPushButton* browseRecordings_;
  QLabel* folderLabel_;
  QLineEdit* folder_;
  QPushButton* browse_;
  QProgressBar* progress_;
  QLabel* state_;
  QPushButton* run_;
  QPushButton* cancel_;
  QPushButton* open_;
  QPushButton* close_;
  QString report_; ///< newest report
};

} // namespace dewpoint::ui
