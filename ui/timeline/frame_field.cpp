// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timeline/frame_field.h"

#include "ui/text/quantity_text.h"
#include "ui/text/retranslation.h"
#include "ui/timeline/entered_place.h"
#include "ui/timeline/timeline.h"

#include <QFocusEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QVBoxLayout>

#include <algorithm>

namespace dewpoint::ui {

namespace {
constexpr int kFrameFieldWidth = 150; ///< pixels
} // namespace

FrameField::FrameField(Timeline& timeline)
    : QFrame(&timeline), timeline_(timeline), edit_(new QLineEdit(this)),
      problem_(new QLabel(this)) {
  setObjectName(QStringLiteral("frameField"));
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  edit_->setObjectName(QStringLiteral("frameFieldEdit"));
  edit_->setMinimumWidth(kFrameFieldWidth);
  edit_->installEventFilter(this);
  problem_->setObjectName(QStringLiteral("frameFieldProblem"));
  problem_->hide();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 2, 4, 2);
  column->setSpacing(2);
  column->addWidget(edit_);
  column->addWidget(problem_);
  connect(edit_, &QLineEdit::returnPressed, this, &FrameField::goToEntered);
  connect(edit_, &QLineEdit::textEdited, this, [this] { showProblem({}); });
  onRetranslate(this, [this] {
    edit_->setPlaceholderText(tr("Frame, or time in s"));
    edit_->setAccessibleName(tr("Frame number or time to go to"));
  });
  hide();
}

void FrameField::open(qint64 currentFrame) {
  openedAt_ = currentFrame;
  edit_->setText(frameNumberText(currentFrame));
  edit_->selectAll();
  problem_->clear();
  problem_->hide();
  place();
  show();
  raise();
  edit_->setFocus(Qt::ShortcutFocusReason);
}

void FrameField::goToEntered() {
  const auto [first, last] = timeline_.reachableFrames();
  const TimelineModel& model = timeline_.model();
  const QLocale numbers;
  if (const auto entered = parseEnteredPosition(edit_->text(), numbers)) {
    const auto* seconds = std::get_if<double>(&*entered);
    // Up to a frame beside the run, so that rounded times of its ends are accepted.
    const double slack = 1.0 / model.framesPerSecond;
    const bool outside = seconds != nullptr && (*seconds < model.secondsOf(first) - slack ||
                                                *seconds > model.secondsOf(last) + slack);
    if (!outside) {
      const qint64 frame = seconds != nullptr
                               ? std::clamp(model.frameAtSeconds(*seconds), first, last)
                               : std::get<qint64>(*entered);
      if (first <= frame && frame <= last) {
        close(true);
        timeline_.goToFrame(frame);
        return;
      }
    }
  }
  //: %1 and %2 are numbers of frames, %3 and %4 times
  showProblem(tr("Enter a frame from %1 to %2, or a time from %3 to %4.")
                  .arg(frameNumberText(first), frameNumberText(last),
                       secondsText(model.secondsOf(first), 2),
                       secondsText(model.secondsOf(last), 2)));
  edit_->selectAll();
}

void FrameField::showProblem(const QString& sentence) {
  if (sentence != problem_->text()) {
    problem_->setText(sentence);
    problem_->setVisible(!sentence.isEmpty());
    edit_->setAccessibleDescription(sentence);
    place();
  }
}

void FrameField::place() {
  layout()->activate();
  resize(sizeHint());
  const int left = timeline_.positionOf(openedAt_).x() - width() / 2;
  move(std::clamp(left, 0, std::max(0, timeline_.width() - width())), 0);
}

void FrameField::close(bool returnsFocus) {
  hide();
  if (returnsFocus) {
    timeline_.setFocus();
  }
}

bool FrameField::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::KeyPress &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    close(true);
    return true;
  }
  if (event->type() == QEvent::FocusOut && isVisible()) {
    const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
    if (reason != Qt::PopupFocusReason && reason != Qt::ActiveWindowFocusReason) {
      close(false);
    }
  }
  return QFrame::eventFilter(watched, event);
}

} // namespace dewpoint::ui
