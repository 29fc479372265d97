// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QFrame>
#include <QStringList>

class QLabel;
class QToolButton;

namespace dewpoint::ui {

/// List of the notices whose causes exist now, one per line, below the message bar. A notice stays
/// as long as its cause, however many there are. The user can hide the notices that are shown; a
/// notice that comes later, or comes back, is shown again.
class NoticeList : public QFrame {
  Q_OBJECT
public:
  /// Number of lines shown at most. If there are more notices, the last line tells how many, and
  /// the tooltip has all of them.
  static constexpr qsizetype kMostLines = 4;

  explicit NoticeList(QWidget* parent = nullptr);

  /// Sets the notices whose causes exist now. Equal texts are one notice.
  void setNotices(const QStringList& notices);
  /// Returns all current notices, also those that the user has hidden.
  const QStringList& notices() const { return notices_; }
  /// Returns how many of the current notices the user has hidden.
  qsizetype hiddenCount() const { return hidden_.size(); }
  /// Hides the notices that are shown now.
  void hideShown();
  /// Shows hidden notices again.
  void showAll();

Q_SIGNALS:
  /// Emitted when a notice is new.
  void began(const QString& notice);
  /// Emitted when the cause of a notice is gone.
  void ended(const QString& notice);
  /// Emitted when the number of hidden notices has changed.
  void hiddenCountChanged(qsizetype count);

protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void refresh();
  void setHidden(const QStringList& hidden);
  void applyPalette();

  QLabel* mark_;
  QLabel* text_;
  QToolButton* close_;
  QStringList notices_;
  QStringList hidden_; ///< current notices that the user has hidden
};

} // namespace dewpoint::ui
