// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QDialog>

class QPlainTextEdit;
class QPushButton;

namespace dewpoint::ui {

class MessageBar;

/// Dialog that lists the messages of the window, each with its time, as text to read and copy. New
/// messages are added while the dialog is open. Not modal.
class MessageHistory : public QDialog {
  Q_OBJECT
public:
  MessageHistory(const MessageBar& messages, QWidget* parent);

  /// Returns all messages listed, one per line.
  QString text() const;

private:
  void retranslateUi();

  QPlainTextEdit* text_;
  QPushButton* copy_;
  QPushButton* close_;
};

} // namespace dewpoint::ui
