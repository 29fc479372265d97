// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/message_bar.h"

#include "ui/style/symbolic_icon.h"
#include "ui/style/theme.h"
#include "ui/text/retranslation.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

namespace {
/// How long a notice stays: to be found, and to be read.
constexpr int kShortestMs = 4000;
constexpr int kMsPerLetter = 70;
constexpr int kBarMargin = 16;
constexpr int kBesideText = 110;  ///< mark, button and margins
constexpr int kAnswerWidth = 170; ///< about that of a button
} // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent), mark_(new QLabel(this)), text_(new QLabel(this)),
      close_(new QToolButton(this)), leave_(new QTimer(this)) {
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
  leave_->setSingleShot(true);
  connect(leave_, &QTimer::timeout, this, &MessageBar::dismiss);
  setFrameShape(QFrame::StyledPanel);
  hide();
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Button);
  applyPalette();
}

void MessageBar::showError(const QString& text) {
  setMessage(text, true);
}
void MessageBar::showNotice(const QString& text) {
  setMessage(text, false);
}
QString MessageBar::text() const {
  return text_->text();
}

void MessageBar::dismiss() {
  leave_->stop();
  text_->clear();
  clearAnswers();
  hide();
  if (std::exchange(showsPending_, false)) {
    pending_.reset();
  } else if (const auto question = pending_) {
    askUntilAnswered(question->text, question->answers);
  }
}

void MessageBar::forget(bool notices) {
  if (isVisible() && answers_.empty() && (isError_ || notices)) {
    dismiss();
  }
}

void MessageBar::askUntilAnswered(const QString& question, const std::vector<Answer>& answers) {
  pending_ = Question{question, answers};
  ask(question, answers);
  showsPending_ = true;
}

void MessageBar::clearAnswers() {
  for (QPushButton* answer : answers_) {
    answer->hide();
    answer->deleteLater(); // it may be the one that was clicked
  }
  answers_.clear();
}

void MessageBar::ask(const QString& question, const std::vector<Answer>& answers) {
  setMessage(question, false);
  auto* row = static_cast<QHBoxLayout*>(layout());
  for (const Answer& answer : answers) {
    auto* button = new QPushButton(answer.first, this);
    button->setObjectName(QStringLiteral("messageAnswer%1").arg(answers_.size()));
    row->insertWidget(row->count() - 1, button);
    connect(button, &QPushButton::clicked, this, [this, act = answer.second] {
      dismiss();
      act();
    });
    answers_.push_back(button);
  }
  leave_->stop();
  place();
}

void MessageBar::setMessage(const QString& text, bool isError) {
  clearAnswers();
  showsPending_ = false;
  isError_ = isError;
  mark_->setText(isError ? QStringLiteral("▲") : QStringLiteral("●"));
  text_->setText(text);
  applyPalette();
  show();
  raise();
  place();
  leaveSoon();
}

void MessageBar::leaveSoon() {
  leave_->stop();
  if (!isError_ && answers_.empty()) {
    leave_->start(kShortestMs + kMsPerLetter * static_cast<int>(text_->text().size()));
  }
}

void MessageBar::keepBelow(QWidget* above) {
  above_ = above;
  parentWidget()->installEventFilter(this);
  for (QObject* sibling : parentWidget()->children()) {
    if (sibling != this) {
      sibling->installEventFilter(this); // one that is raised would cover it
    }
  }
}

void MessageBar::place() {
  const int most = parentWidget()->width() - 2 * kBarMargin;
  const int wanted = text_->fontMetrics().horizontalAdvance(text_->text()) + kBesideText +
                     static_cast<int>(answers_.size()) * kAnswerWidth;
  const int width = std::min(most, wanted);
  const int top = above_ != nullptr ? above_->geometry().bottom() + 1 : 0;
  resize(width,
         layout()->hasHeightForWidth() ? layout()->heightForWidth(width) : sizeHint().height());
  move((parentWidget()->width() - width) / 2, top + kBarMargin / 2);
}

void MessageBar::enterEvent(QEnterEvent* event) {
  leave_->stop();
  QFrame::enterEvent(event);
}

void MessageBar::leaveEvent(QEvent* event) {
  if (isVisible()) {
    leaveSoon();
  }
  QFrame::leaveEvent(event);
}

bool MessageBar::eventFilter(QObject* watched, QEvent* event) {
  const bool moved = event->type() == QEvent::Resize || event->type() == QEvent::Move;
  if (isVisible() && moved && (watched == parent() || watched == above_)) {
    place();
  } else if (event->type() == QEvent::ChildAdded && watched == parent()) {
    static_cast<QChildEvent*>(event)->child()->installEventFilter(this);
  } else if (event->type() == QEvent::ZOrderChange && watched != this && isVisible()) {
    // Later: a dock comes to the front of its tabs only if it is the topmost when it is told so.
    QMetaObject::invokeMethod(this, &QWidget::raise, Qt::QueuedConnection);
  }
  return QFrame::eventFilter(watched, event);
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
  const QColor color =
      isError_ ? holdColor(HoldState::Lost, palette()) : palette().color(QPalette::Link);
  if (colors.color(QPalette::WindowText) != color) {
    colors.setColor(QPalette::WindowText, color);
    mark_->setPalette(colors);
  }
}

} // namespace dewpoint::ui
