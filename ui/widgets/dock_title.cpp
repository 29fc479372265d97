// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/dock_title.h"

#include "ui/style/symbolic_icon.h"
#include "ui/text/retranslation.h"
#include "ui/text/tracking_state_text.h"
#include "ui/widgets/elided_label.h"

#include <QDockWidget>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QToolButton>

#include <algorithm>

namespace dewpoint::ui {

namespace {
constexpr int kLeastNameWidth = 24;
constexpr int kLeastStateWidth = 16; ///< its sign is seen

/// Paints text that does not fit with an ellipsis. Its text() is always the whole text.
class TitleLabel : public QLabel {
public:
  using QLabel::QLabel;

protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter painter(this);
    painter.setPen(palette().color(foregroundRole()));
    painter.drawText(rect(), Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(text(), Qt::ElideRight, width()));
  }
};
} // namespace

DockTitle::DockTitle(QDockWidget* dock)
    : QWidget(dock), dock_(dock), name_(new TitleLabel(dock->windowTitle(), this)),
      state_(new TitleLabel(this)), reason_(new ElidedLabel(this)), restore_(new QToolButton(this)),
      float_(new QToolButton(this)) {
  setObjectName(dock->objectName() + QStringLiteral("Title"));
  name_->setObjectName(objectName() + QStringLiteral("Name"));
  state_->setObjectName(objectName() + QStringLiteral("State"));
  reason_->setObjectName(objectName() + QStringLiteral("Reason"));
  float_->setObjectName(objectName() + QStringLiteral("Float"));
  float_->setAutoRaise(true);
  float_->setIconSize({14, 14});
  float_->setFocusPolicy(Qt::NoFocus);
  restore_->setObjectName(objectName() + QStringLiteral("Restore"));
  restore_->setIconSize({14, 14});
  restore_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  restore_->setFocusPolicy(Qt::NoFocus);
  restore_->hide();
  onRetranslate(this, [this] {
    float_->setToolTip(
        tr("Float or dock this view (to maximize the view, double-click its title)"));
    restore_->setText(tr("Show all views"));
    restore_->setToolTip(tr("Restore the other views (Esc, or double-click here)"));
    applyPalette();
  });
  QFont bold = name_->font();
  bold.setWeight(QFont::DemiBold);
  name_->setFont(bold);

  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 3, 4, 3);
  layout->setSpacing(8);
  layout->addWidget(name_);
  layout->addWidget(state_);
  layout->addWidget(reason_, 1);
  layout->addWidget(restore_);
  layout->addWidget(float_);
  // A narrow view is not kept from being narrow by its words.
  name_->setMinimumWidth(kLeastNameWidth);
  state_->setMinimumWidth(kLeastStateWidth);
  connect(float_, &QToolButton::clicked, this, &DockTitle::floatRequested);
  connect(restore_, &QToolButton::clicked, this, &DockTitle::maximizeRequested);
  connect(dock_, &QDockWidget::windowTitleChanged, this, [this](const QString& title) {
    name_->setText(title);
    fitName();
  });
  applyPalette();
}

QSize DockTitle::minimumSizeHint() const {
  const QSize least = layout()->minimumSize();
  const int spare = name_->isHidden() ? 0 : name_->minimumWidth() - kLeastNameWidth;
  return {least.width() - spare, least.height()};
}

void DockTitle::fitName() {
  if (name_->isHidden()) {
    return;
  }
  const int others = layout()->minimumSize().width() - name_->minimumWidth();
  const int whole = std::max(kLeastNameWidth, name_->sizeHint().width());
  name_->setMinimumWidth(std::clamp(width() - others, kLeastNameWidth, whole));
}

void DockTitle::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  fitName();
}

void DockTitle::setNameShown(bool shown) {
  name_->setVisible(shown);
  fitName();
  update();
}

void DockTitle::setState(TrackingState state) {
  stateful_ = true;
  shown_ = state;
  applyPalette();
}

void DockTitle::setReason(const QString& reason) {
  showReason(reason, false);
}

void DockTitle::showReasonInsteadOfState(const QString& reason) {
  showReason(reason, true);
}

void DockTitle::showReason(const QString& reason, bool alone) {
  if (reason_->toolTip() != reason) {
    reason_->setFullText(reason);
  }
  if (reasonAlone_ != alone) {
    reasonAlone_ = alone;
    state_->setVisible(!alone);
    fitName();
    applyPalette();
  }
}

void DockTitle::addTool(QWidget* tool) {
  auto* row = static_cast<QHBoxLayout*>(layout());
  row->insertWidget(row->indexOf(restore_), tool);
  fitName();
}

void DockTitle::setMaximized(bool maximized) {
  restore_->setVisible(maximized);
  float_->setVisible(!maximized);
  fitName();
}

void DockTitle::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) {
    applyPalette();
  }
}

void DockTitle::mouseDoubleClickEvent(QMouseEvent* event) {
  event->accept();
  Q_EMIT maximizeRequested();
}

void DockTitle::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  // Below a tab it belongs to what the tab shows.
  painter.fillRect(rect(),
                   palette().color(name_->isHidden() ? QPalette::Window : QPalette::Button));
}

void DockTitle::applyPalette() {
  float_->setIcon(symbolicIcon(QStringLiteral("float"), palette()));
  restore_->setIcon(symbolicIcon(QStringLiteral("all-views"), palette()));
  if (stateful_) {
    state_->setText(trackingStateText(shown_));
    QPalette colors = state_->palette();
    const QColor color = trackingStateColor(shown_, palette());
    if (colors.color(QPalette::WindowText) != color) {
      colors.setColor(QPalette::WindowText, color);
      state_->setPalette(colors);
    }
  }
  QPalette colors; // of nothing in particular: that of the title
  if (reasonAlone_) {
    colors = palette();
    colors.setColor(QPalette::WindowText, trackingStateColor(TrackingState::Hidden, palette()));
  }
  reason_->setPalette(colors);
}

} // namespace dewpoint::ui
