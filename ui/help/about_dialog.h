// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QDialog>

class QLabel;
class QPlainTextEdit;
class QPushButton;

namespace dewpoint::ui {

/// Shows the version, a description of Dewpoint, its license with the full text, and how to cite
/// it. Not modal.
class AboutDialog : public QDialog {
  Q_OBJECT
public:
  explicit AboutDialog(QWidget* parent);

private:
  void retranslateUi();
  void showLicense();

  QLabel* name_;
  QLabel* purpose_;
  QLabel* license_;
  QLabel* citeHeading_;
  QLabel* citation_;
  QPlainTextEdit* licenseText_;
  QPushButton* showLicense_;
  QPushButton* copy_;
  QPushButton* close_;
};

} // namespace dewpoint::ui
