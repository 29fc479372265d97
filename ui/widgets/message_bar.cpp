// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/message_bar.h"

#include "ui/style/mixed_color.h"
#include "ui/style/symbolic_icon.h"
#include "ui/style/theme.h"
#include "ui/text/retranslation.h"

#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QTime>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

namespace {
/// How long a notice stays: to be found, and to be read.
constexpr int kShortestMs = 4000;
constexpr int kMsPerLetter = 70;
constexpr qsizetype kMostRecent = 1000;
/// How much of a message's color is in its ground and in its edge: quiet, but seen.
constexpr double kTint = 0.10;
constexpr double kEdge = 0.45;

} // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), mark_(new QLabel(this)), text_(new QLabel(this)),
      close_(new QToolButton(this)), hideTimer_(new QTimer(this)) {
  setObjectName(QStringLiteral("messageBar"));
  mark_->setObjectName(QStringLiteral("messageMark"));
  text_->setObjectName(QStringLiteral("messageText"));
  text_->setWordWrap(true);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  close_->setObjectName(QStringLiteral("messageClose"));
  close_->setAutoRaise(true);
  onRetranslate(this, [this] { close_->setToolTip(tr("Close this message")); });
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12, 4, 8, 4);
  layout->setSpacing(8);
  layout->addWidget(mark_);
  layout->addWidget(text_, 1);
  layout->addWidget(close_);
  connect(close_, &QToolButton::clicked, this, &MessageBar::dismiss);
  hideTimer_->setSingleShot(true);
  connect(hideTimer_, &QTimer::timeout, this, &MessageBar::dismiss);
  setBackgroundRole(QPalette::Window);  // else the colors of a toolbar's buttons are taken
  close_->setFocusPolicy(Qt::TabFocus); // a click leaves the keys where they are
  connect(qApp, &QApplication::focusChanged, this, &MessageBar::rememberFocus);
  hide();
  applyPalette();
}

void MessageBar::showError(const QString& text) {
  setMessage(text, Severity::Error);
}
void MessageBar::showWarning(const QString& text) {
  setMessage(text, Severity::Warning);
}
void MessageBar::showNotice(const QString& text) {
  setMessage(text, Severity::Information);
}
QString MessageBar::text() const {
  return text_->text();
}

void MessageBar::dismiss() {
  hideTimer_->stop();
  returnFocus(); // before it would go to whatever comes next
  text_->clear();
  clearAnswers();
  hide();
  if (std::exchange(showsPending_, false)) {
    pending_.pop_back();
  }
  if (!pending_.empty()) {
    const Question next = pending_.back();
    showLastingQuestion(next.text, next.answers);
  }
}

void MessageBar::removeOldMessages(bool notices) {
  if (isVisible() && answers_.empty() && (severity_ != Severity::Information || notices)) {
    dismiss();
  }
}

void MessageBar::showLastingQuestion(const QString& question, const std::vector<Answer>& answers) {
  std::erase_if(pending_, [&](const Question& asked) { return asked.text == question; });
  pending_.push_back({question, answers});
  showQuestion(question, answers);
  showsPending_ = true;
}

void MessageBar::withdrawQuestion(const QString& question) {
  if (!isHidden() && text() == question) {
    dismiss();
  }
  std::erase_if(pending_, [&](const Question& asked) { return asked.text == question; });
}

bool MessageBar::isQuestionOpen(const QString& question) const {
  return std::ranges::any_of(pending_,
                             [&](const Question& asked) { return asked.text == question; });
}

void MessageBar::clearAnswers() {
  for (QPushButton* answer : answers_) {
    answer->hide();
    answer->deleteLater(); // it may be the one that was clicked
  }
  answers_.clear();
}

void MessageBar::showQuestion(const QString& question, const std::vector<Answer>& answers) {
  setMessage(question, Severity::Information);
  auto* row = static_cast<QHBoxLayout*>(layout());
  for (const Answer& answer : answers) {
    auto* button = new QPushButton(answer.first, this);
    button->setObjectName(QStringLiteral("messageAnswer%1").arg(answers_.size()));
    button->setFocusPolicy(Qt::TabFocus);
    button->setAutoDefault(false);
    row->insertWidget(row->count() - 1, button);
    connect(button, &QPushButton::clicked, this, [this, act = answer.second] {
      dismiss();
      act();
    });
    button->show(); // the bar is shown already: it needs the room
    answers_.push_back(button);
  }
  hideTimer_->stop();
  updateGeometry();
}

void MessageBar::setMessage(const QString& text, Severity severity) {
  returnFocus();
  clearAnswers();
  showsPending_ = false;
  severity_ = severity;
  mark_->setText(markOf(severity));
  text_->setText(text);
  applyPalette();
  show();
  updateGeometry();
  startHideTimer();
  record(text, severity);
}

QString MessageBar::markOf(Severity severity) {
  return severity == Severity::Information ? QStringLiteral("●")
         : severity == Severity::Warning   ? QStringLiteral("◆")
                                           : QStringLiteral("▲");
}

void MessageBar::record(const QString& text, Severity severity) {
  recent_.append(
      QStringLiteral("%1  %2  %3")
          .arg(QTime::currentTime().toString(QStringLiteral("HH:mm:ss")), markOf(severity), text));
  if (recent_.size() > kMostRecent) {
    recent_.removeFirst();
  }
  Q_EMIT messageShown(text);
}

void MessageBar::startHideTimer() {
  hideTimer_->stop();
  if (severity_ == Severity::Information && answers_.empty()) {
    hideTimer_->start(kShortestMs + kMsPerLetter * static_cast<int>(text_->text().size()));
  }
}

void MessageBar::rememberFocus(QWidget* before, const QWidget* now) {
  if (now != nullptr && isAncestorOf(now) && (before == nullptr || !isAncestorOf(before))) {
    focusBefore_ = before;
  }
}

void MessageBar::returnFocus() {
  QWidget* now = QApplication::focusWidget();
  if (now == nullptr || !isAncestorOf(now)) {
    return;
  }
  if (focusBefore_ != nullptr && focusBefore_->isVisible() && focusBefore_->isEnabled()) {
    focusBefore_->setFocus(Qt::OtherFocusReason);
  } else {
    now->clearFocus(); // keys go to the window, as long as nobody chooses another place
  }
}

void MessageBar::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) {
    dismiss();
  } else {
    QFrame::keyPressEvent(event);
  }
}

QColor MessageBar::severityColor() const {
  return severity_ == Severity::Error     ? trackingStateColor(TrackingState::Lost, palette())
         : severity_ == Severity::Warning ? trackingStateColor(TrackingState::Ambiguous, palette())
                                          : palette().color(QPalette::Link);
}

void MessageBar::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const QColor ground = palette().color(QPalette::Window);
  painter.fillRect(rect(), mixedColor(ground, severityColor(), kTint));
  painter.fillRect(QRect(0, height() - 1, width(), 1), mixedColor(ground, severityColor(), kEdge));
}

void MessageBar::enterEvent(QEnterEvent* event) {
  hideTimer_->stop();
  QFrame::enterEvent(event);
}

void MessageBar::leaveEvent(QEvent* event) {
  if (isVisible()) {
    startHideTimer();
  }
  QFrame::leaveEvent(event);
}

void MessageBar::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    applyPalette();
  }
}

void MessageBar::applyPalette() {
  close_->setIcon(symbolicIcon(QStringLiteral("close"), palette()));
  QPalette colors = mark_->palette();
  const QColor color = severityColor();
  if (colors.color(QPalette::WindowText) != color) {
    colors.setColor(QPalette::WindowText, color);
    mark_->setPalette(colors);
  }
  update();
}

} // namespace dewpoint::ui
