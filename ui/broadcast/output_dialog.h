// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QSpinBox;

namespace dewpoint::ui {

class Document;

/// Dialog for the outputs that send results to other programs during a run (OutputSettings).
/// Pressing OK changes the project in one undoable step.
class OutputDialog : public QDialog {
  Q_OBJECT
public:
  OutputDialog(Document& document, QWidget* parent);

private:
  void arrange();
  void setSettings(const OutputSettings& settings);
  OutputSettings settings() const;
  void apply();
  void retranslateUi();

  Document& document_;
  QLabel* intro_;
  QFormLayout* form_;
  QCheckBox* tcp_;
  QSpinBox* tcpPort_;
  QCheckBox* web_;
  QSpinBox* webPort_;
  QLabel* page_; ///< address of the page for browsers
  QLineEdit* osc_;
  QLineEdit* tuio_;
  QLineEdit* csv_;
  QComboBox* listen_;
  QComboBox* axes_;
  QComboBox* unit_;
  QSpinBox* rate_;
  QLineEdit* token_;
  QLabel* problem_;
  QDialogButtonBox* buttons_;
};

} // namespace dewpoint::ui
