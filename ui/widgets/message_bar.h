// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QFrame>
#include <QPointer>
#include <QStringList>

#include <functional>
#include <optional>
#include <vector>

class QLabel;
class QHBoxLayout;
class QPushButton;
class QTimer;
class QToolButton;

namespace dewpoint::ui {

/// How much a message matters: a word, a color and a shape for each.
enum class Severity { Information, Warning, Error };

/// One sentence in a strip across the window (MessageRow): what failed, what is worth knowing, or a
/// question with its answers. It blocks nothing. What is only worth knowing goes by itself when
/// there was time to read it; the others stay until closed, answered or replaced. Where the keys
/// went before somebody answered or closed it, they go again.
class MessageBar : public QFrame {
  Q_OBJECT
public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showError(const QString& text);
  /// What needs attention, and stays until it is closed.
  void showWarning(const QString& text);
  void showNotice(const QString& text);
  /// An answer: its text, and what it does.
  using Answer = std::pair<QString, std::function<void()>>;
  /// Asks; closing the bar answers nothing.
  void ask(const QString& question, const std::vector<Answer>& answers);
  /// Asks, and asks again whenever another message that replaced the question has gone, until it
  /// was answered or closed.
  void askUntilAnswered(const QString& question, const std::vector<Answer>& answers);
  QString text() const;
  /// Takes away what it says.
  void dismiss();
  /// Other work has begun: an error is over, and with `notices` so is what was worth knowing.
  /// Questions stay.
  void forget(bool notices);
  /// The last messages of this window, oldest first, each with the time at which it came.
  const QStringList& recent() const { return recent_; }

protected:
  void enterEvent(QEnterEvent* event) override; ///< whoever points at it reads it
  void leaveEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override; ///< Esc closes it
  void changeEvent(QEvent* event) override;

private:
  void setMessage(const QString& text, Severity severity);
  void clearAnswers();
  QColor inkOfSeverity() const;
  void applyPalette();
  void leaveSoon();
  void rememberFocus(QWidget* before, const QWidget* now);
  void returnFocus();

  QLabel* mark_;
  QLabel* text_;
  QToolButton* close_;
  QTimer* leave_;
  std::vector<QPushButton*> answers_;
  Severity severity_ = Severity::Information;
  QPointer<QWidget> focusBefore_; ///< what had the keys before a part of this got them
  QStringList recent_;
  struct Question {
    QString text;
    std::vector<Answer> answers;
  };
  std::optional<Question> pending_; ///< to be answered
  bool showsPending_ = false;
};

} // namespace dewpoint::ui
