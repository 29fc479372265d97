// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QDialog>

#include <vector>

class QAction;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace dewpoint::ui {

/// Short introduction: the parts of the window, the words for the target states, and five steps to
/// get started. Not modal.
class QuickStart : public QDialog {
  Q_OBJECT
public:
  /// Actions that the text mentions with their shortcuts, or that buttons trigger.
  struct Actions {
    QAction* openProject;
    QAction* calibrate;
    QAction* play;
    QAction* exportTrajectory;
    QAction* legend;
    QAction* manual;
  };
  QuickStart(const Actions& actions, QWidget* parent);

protected:
  void changeEvent(QEvent* event) override;

private:
  QLabel* addHeading(QVBoxLayout* column);
  QLabel* addText(QVBoxLayout* column);
  void addStates(QVBoxLayout* column);
  void retranslateUi();
  void showStates();

  Actions actions_;
  QLabel* seenHeading_ = nullptr;
  QLabel* seenText_ = nullptr;
  QLabel* stateHeading_ = nullptr;
  QLabel* beginHeading_ = nullptr;
  std::vector<QLabel*> stateWords_;
  std::vector<QLabel*> stateTexts_;
  std::vector<QLabel*> steps_;
  QPushButton* legend_;
  QPushButton* manual_;
  QPushButton* close_;
};

} // namespace dewpoint::ui
