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

namespace dewpoint::ui {

class BackgroundJob;

/// What the dialogs that bring calibrations in and out have in common: a file, some questions, a
/// preview that is made in a thread whenever an answer changes, and a button that does it. Not
/// modal.
class ExchangeDialog : public QDialog {
  Q_OBJECT
public:
  ExchangeDialog(const QString& name, QWidget* parent);

  QString file() const;
  void setFile(const QString& file);
  /// Whether what the preview shows can be done.
  bool isReady() const { return ready_; }

Q_SIGNALS:
  void done(const QString& sentence);
  void failed(const QString& sentence);

protected:
  /// Makes what is shown; runs in a thread, the function returned in the window's.
  using Preview = std::function<std::function<void()>()>;
  virtual Preview preview() = 0;
  virtual void accepted() = 0;
  virtual void chooseFile() = 0;
  virtual void retranslateFields() = 0;

  /// To be called once the questions are there.
  void begin();
  /// An answer changed: the preview is made again.
  void refresh();
  /// Runs something that takes long, beside the window; nothing can be accepted meanwhile.
  void work(const Preview& task);
  void showPreview(const QString& text, bool ready);
  QComboBox* addChoice(const char* name);
  QLabel* addRow(QWidget* field);
  void addButton(QPushButton* button);

  QLabel* fileLabel_;
  QPushButton* choose_;
  QPushButton* accept_;

private:
  void start();

  QLineEdit* file_;
  QFormLayout* form_;
  QHBoxLayout* fileRow_;
  QLabel* previewLabel_;
  QPlainTextEdit* preview_;
  QPushButton* close_;
  BackgroundJob* job_;
  bool ready_ = false;
  bool again_ = false; ///< an answer changed while a preview was made
};

} // namespace dewpoint::ui
