// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/notice_list.h"

#include "ui/style/mixed_color.h"
#include "ui/style/symbolic_icon.h"
#include "ui/style/theme.h"
#include "ui/text/retranslation.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>

#include <utility>

namespace dewpoint::ui {

namespace {
/// How much of the color of a warning is in the ground: as in the message bar.
constexpr double kNoticeTint = 0.10;
} // namespace

NoticeList::NoticeList(QWidget* parent)
    : QFrame(parent), mark_(new QLabel(QStringLiteral("◆"), this)), text_(new QLabel(this)),
      close_(new QToolButton(this)) {
  setObjectName(QStringLiteral("noticeList"));
  text_->setObjectName(QStringLiteral("noticesText"));
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  close_->setObjectName(QStringLiteral("noticesClose"));
  close_->setAutoRaise(true);
  close_->setFocusPolicy(Qt::TabFocus); // a click leaves the keys where they are
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12, 4, 8, 4);
  layout->setSpacing(8);
  layout->addWidget(mark_, 0, Qt::AlignTop);
  layout->addWidget(text_, 1);
  layout->addWidget(close_, 0, Qt::AlignTop);
  setBackgroundRole(QPalette::Window);
  connect(close_, &QToolButton::clicked, this, &NoticeList::hideShown);
  onRetranslate(this, [this] {
    close_->setToolTip(tr("Hide these notices. The status bar shows how many are hidden"));
    refresh();
  });
  applyPalette();
}

void NoticeList::setNotices(const QStringList& notices) {
  QStringList wanted = notices;
  wanted.removeDuplicates();
  if (wanted == notices_) {
    return;
  }
  const QStringList before = std::exchange(notices_, wanted);
  QStringList hidden = hidden_;
  hidden.removeIf([&](const QString& notice) { return !notices_.contains(notice); });
  setHidden(hidden);
  refresh();
  for (const QString& notice : before) {
    if (!wanted.contains(notice)) {
      Q_EMIT noticeEnded(notice);
    }
  }
  for (const QString& notice : wanted) {
    if (!before.contains(notice)) {
      Q_EMIT noticeBegan(notice);
    }
  }
}

void NoticeList::hideShown() {
  setHidden(notices_);
  refresh();
}

void NoticeList::showAll() {
  setHidden({});
  refresh();
}

void NoticeList::setHidden(const QStringList& hidden) {
  const bool isOther = hidden.size() != hidden_.size();
  hidden_ = hidden;
  if (isOther) {
    Q_EMIT hiddenCountChanged(hidden_.size());
  }
}

void NoticeList::refresh() {
  QStringList lines = notices_;
  lines.removeIf([this](const QString& notice) { return hidden_.contains(notice); });
  const QString all = lines.join(QLatin1Char('\n'));
  const auto more = static_cast<int>(lines.size() - kMaxNoticeLines);
  if (more > 0) {
    lines.resize(kMaxNoticeLines);
    lines += tr("and %n more notice(s)", nullptr, more);
  }
  text_->setText(lines.join(QLatin1Char('\n')));
  text_->setToolTip(more > 0 ? all : QString());
  setVisible(!lines.isEmpty());
  updateGeometry();
}

void NoticeList::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const QColor ground = palette().color(QPalette::Window);
  painter.fillRect(
      rect(),
      mixedColor(ground, trackingStateColor(TrackingState::Ambiguous, palette()), kNoticeTint));
}

void NoticeList::changeEvent(QEvent* event) {
  QFrame::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    applyPalette();
  }
}

void NoticeList::applyPalette() {
  close_->setIcon(symbolicIcon(QStringLiteral("close"), palette()));
  QPalette colors = mark_->palette();
  const QColor color = trackingStateColor(TrackingState::Ambiguous, palette());
  if (colors.color(QPalette::WindowText) != color) {
    colors.setColor(QPalette::WindowText, color);
    mark_->setPalette(colors);
  }
  update();
}

} // namespace dewpoint::ui
