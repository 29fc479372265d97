// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <vector>

class QDialog;
class QLayout;
class QPushButton;
class QWidget;

namespace dewpoint::ui {

/// Parts that the dialogs of exports have below their own content.
struct ExportDialogParts {
  QWidget* file;     ///< field for the file to write
  QWidget* browse;   ///< chooses this file
  QWidget* question; ///< whether an existing file may be replaced
  QWidget* outcome;  ///< what became of the last export
  QWidget* progress;
  QWidget* cancel;
  std::vector<QPushButton*> actions; ///< start something
  QPushButton* close;
};

/// Arranges a dialog: `content`, the file, messages, and a row of buttons. No button is pressed by
/// Enter.
void arrangeExportDialog(QDialog& dialog, QLayout* content, const ExportDialogParts& parts);

} // namespace dewpoint::ui
