// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QDialog>

#include <functional>

class QComboBox;
class QFormLayout;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QPushButton;
class QTimer;

namespace dewpoint::ui {

class BackgroundJob;

/// Base class of the dialogs that import and export calibrations. They consist of a file, some
/// questions, a preview, and a button to accept. The preview is recomputed in another thread
/// whenever an answer changes. Not modal.
class ExchangeDialog : public QDialog {
  Q_OBJECT
public:
  ExchangeDialog(const QString& name, QWidget* parent);

  QString file() const;
  void setFile(const QString& file);
  /// Returns whether the previewed operation can be carried out.
  bool isReady() const { return ready_; }
  /// Returns whether the preview was computed while the user is still typing. Errors are then shown
  /// in the preview only.
  bool isTyping() const { return typing_; }

Q_SIGNALS:
  void completed(const QString& sentence);
  void failed(const QString& sentence);

protected:
  /// Function that computes the preview in another thread. The function that it returns shows the
  /// preview, and runs in the GUI thread.
  using Preview = std::function<std::function<void()>()>;
  virtual Preview makePreview() = 0;
  virtual void performExchange() = 0;
  virtual void chooseFile() = 0;
  virtual void retranslateFields() = 0;

  /// Completes the layout of the dialog. Call this after adding all questions.
  void finishLayout();
  /// Sets the proposed file without computing a preview.
  void proposeFile(const QString& file);
  /// Recomputes the preview after an answer has changed.
  void refresh();
  /// Runs a long task in another thread. The dialog cannot be accepted until the task ends.
  void runTask(const Preview& task);
  void showPreview(const QString& text, bool ready);
  /// Shows the result of a task in place of the preview. The dialog cannot be accepted again until
  /// there is a new preview.
  void showResult(const QString& text);
  QComboBox* addComboBox(const char* name);
  QLabel* addRow(QWidget* field);
  void addButton(QPushButton* button);

  QLabel* fileLabel_;
  QPushButton* choose_;
  QPushButton* accept_;

private:
  void start();
  void refreshPreview();
  void setShowsResult(bool shows);

  QLineEdit* file_;
  QFormLayout* form_;
  QHBoxLayout* fileRow_;
  QLabel* previewLabel_;
  bool showsResult_ = false; ///< instead of a preview
  QPlainTextEdit* preview_;
  QPushButton* close_;
  BackgroundJob* job_;
  QTimer* typingPause_; ///< runs while a text is being typed
  bool ready_ = false;
  bool typing_ = false;
  bool rerunPreview_ = false; ///< an answer changed while a preview was being computed
};

} // namespace dewpoint::ui
