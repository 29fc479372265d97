// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/jobs/background_job.h"

#include <QSize>
#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace dewpoint::ui {

/// Form that adds network cameras, GStreamer pipelines and test patterns by their address. The
/// button *Try* opens the address in another thread, and shows the first image with size and rate,
/// or the reason why there is none.
class AddressForm : public QWidget {
  Q_OBJECT
public:
  explicit AddressForm(QWidget* parent = nullptr);

  /// Sets the reason why addresses cannot be added to this project; empty if they can.
  void setBlockedReason(const QString& reason);

Q_SIGNALS:
  /// Emitted when the user wants to add a camera with this address. `size` is the size of its
  /// images in pixels; empty if the address has not been tried.
  void addRequested(const QString& address, const QSize& size);
  /// Emitted when the user wants to make this address the source of the selected camera.
  void replaceRequested(const QString& address);

private:
  void arrange();
  void retranslateUi();
  void refresh();
  void chooseKind(int kind);
  void tryAddress();
  QString address() const;

  QLabel* label_;
  QComboBox* kind_;
  QLineEdit* address_;
  QPushButton* try_;
  QPushButton* add_;
  QPushButton* replace_;
  QLabel* image_;
  QLabel* result_;
  QString blockedReason_;
  QString tried_; ///< address that the result is about
  QSize size_;    ///< of its images
  BackgroundJob job_;
};

} // namespace dewpoint::ui
