// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QFrame>
#include <QStringList>

class QLabel;
class QToolButton;

namespace dewpoint::ui {

/// List below the message bar of all notices whose causes currently exist, one per line. A notice
/// is shown until its cause is gone. The user can hide the notices that are shown; new notices, and
/// notices that come back, are shown again.
class NoticeList : public QFrame {
  Q_OBJECT
public:
  /// Maximum number of lines. If there are more notices, the last line states how many, and the
  /// tooltip lists all notices.
  static constexpr qsizetype kMaxNoticeLines = 4;

  explicit NoticeList(QWidget* parent = nullptr);

  /// Sets the notices whose causes currently exist. Equal texts count as one notice.
  void setNotices(const QStringList& notices);
  /// Returns all current notices, including those that the user has hidden.
  const QStringList& notices() const { return notices_; }
  /// Returns how many of the current notices the user has hidden.
  qsizetype hiddenCount() const { return hidden_.size(); }
  /// Hides all notices that are currently shown.
  void hideShown();
  /// Shows all hidden notices again.
  void showAll();

Q_SIGNALS:
  /// Emitted when a notice begins, because its cause has appeared.
  void noticeBegan(const QString& notice);
  /// Emitted when a notice ends, because its cause is gone.
  void noticeEnded(const QString& notice);
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
