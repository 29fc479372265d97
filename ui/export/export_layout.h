// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <vector>

class QDialog;
class QLayout;
class QPushButton;
class QWidget;

namespace dewpoint::ui {

/// Widgets that all export dialogs have below their own content.
struct ExportDialogParts {
  QWidget* fileField;    ///< field for the file to write
  QWidget* browseButton; ///< button that opens a file dialog for this file
  QWidget* question;     ///< question whether an existing file may be replaced
  QWidget* outcome;      ///< result of the last export
  QWidget* progressBar;
  QWidget* cancelButton;
  std::vector<QPushButton*> actionButtons; ///< buttons that start an export or another task
  QPushButton* closeButton;
};

/// Arranges the widgets of an export dialog: `content`, the file, messages, and a row of buttons.
/// Enter presses no button.
void arrangeExportDialog(QDialog& dialog, QLayout* content, const ExportDialogParts& parts);

} // namespace dewpoint::ui
