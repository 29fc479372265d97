// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QFrame>
#include <QPointer>
#include <QStringList>

#include <functional>
#include <vector>

class QLabel;
class QHBoxLayout;
class QPushButton;
class QTimer;
class QToolButton;

namespace dewpoint::ui {

/// Severity of a message. Each severity is shown by a word, a color and a shape.
enum class Severity { Information, Warning, Error };

/// Message strip across the window (MessageRow) with one sentence: an error, a notice, or a
/// question with answers. It does not block the window. A notice disappears after a time long
/// enough to read it. Other messages stay until closed, answered or replaced. When the user answers
/// or closes a message, the keyboard focus returns to its previous widget.
class MessageBar : public QFrame {
  Q_OBJECT
public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showError(const QString& text);
  /// Shows a message that needs attention. It stays until closed.
  void showWarning(const QString& text);
  void showNotice(const QString& text);
  /// Answer to a question: its text, and the function it calls.
  using Answer = std::pair<QString, std::function<void()>>;
  /// Asks a question. Closing the bar gives no answer.
  void showQuestion(const QString& question, const std::vector<Answer>& answers);
  /// Asks a question until the user answers or closes it. If another message replaces the question,
  /// the question is asked again when this message is gone. Several questions can wait; the newest
  /// is asked first.
  void showLastingQuestion(const QString& question, const std::vector<Answer>& answers);
  /// Removes a question that no longer needs an answer, whether it is shown or waits.
  void withdrawQuestion(const QString& question);
  /// Returns whether this question, asked with showLastingQuestion(), is shown or waits to be
  /// shown.
  bool isQuestionOpen(const QString& question) const;
  QString text() const;
  /// Removes the current message.
  void dismiss();
  /// Removes the current error or warning, for example because other work has begun. If `notices`
  /// is true, also removes a notice. Questions stay.
  void removeOldMessages(bool notices);
  /// Adds a message to the list of recent messages without showing it, because it is shown
  /// elsewhere.
  void record(const QString& text, Severity severity);
  /// Returns the last messages of this window (at most 1000), oldest first, each with its time.
  const QStringList& recentMessages() const { return recent_; }

Q_SIGNALS:
  /// Emitted with the text of every message and question, including messages that are only
  /// recorded.
  void messageShown(const QString& text);

protected:
  void enterEvent(QEnterEvent* event) override; ///< keeps a notice while the pointer is over it
  void leaveEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override; ///< Esc closes the message
  void changeEvent(QEvent* event) override;

private:
  void setMessage(const QString& text, Severity severity);
  void clearAnswers();
  static QString markOf(Severity severity);
  QColor severityColor() const;
  void applyPalette();
  void startHideTimer();
  void rememberFocus(QWidget* before, const QWidget* now);
  void returnFocus();

  QLabel* mark_;
  QLabel* text_;
  QToolButton* close_;
  QTimer* hideTimer_;
  std::vector<QPushButton*> answers_;
  Severity severity_ = Severity::Information;
  QPointer<QWidget> focusBefore_; ///< widget that had the keyboard focus before the bar got it
  QStringList recent_;
  struct Question {
    QString text;
    std::vector<Answer> answers;
  };
  std::vector<Question> pending_; ///< questions that still need an answer, the newest last
  bool showsPending_ = false;
};

} // namespace dewpoint::ui
