// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/collapsible_section.h"

#include "ui/style/spacing.h"
#include "ui/style/type_scale.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace dewpoint::ui {

CollapsibleSection::CollapsibleSection(const QString& title, QWidget* parent)
    : QWidget(parent), header_(new QToolButton(this)), mark_(new QLabel(QStringLiteral("●"), this)),
      body_(new QWidget(this)), rows_(new QVBoxLayout(body_)) {
  header_->setObjectName(QStringLiteral("sectionHead"));
  header_->setText(title);
  header_->setFont(headingFont(font()));
  header_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  header_->setAutoRaise(true);
  header_->setFocusPolicy(Qt::StrongFocus);
  header_->setIconSize({10, 10});
  mark_->setForegroundRole(QPalette::Highlight);
  mark_->setFont(smallerFont(font()));
  mark_->hide();
  rows_->setContentsMargins(0, kSpacing / 2, 0, kSpacing);
  rows_->setSpacing(2 * kSpacing);
  auto* heading = new QHBoxLayout;
  heading->setSpacing(kSpacing / 2);
  heading->addWidget(header_);
  heading->addWidget(mark_);
  heading->addStretch();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(heading);
  column->addWidget(body_);
  setOpen(false);
  connect(header_, &QToolButton::clicked, this, [this] {
    setOpen(!isOpen());
    Q_EMIT openedByUser(isOpen());
  });
}

void CollapsibleSection::addWidget(QWidget* widget) {
  rows_->addWidget(widget);
}

bool CollapsibleSection::isOpen() const {
  return !body_->isHidden();
}

void CollapsibleSection::setOpen(bool open) {
  body_->setVisible(open);
  header_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
}

void CollapsibleSection::setAttentionHint(const QString& hint) {
  mark_->setVisible(!hint.isEmpty());
  mark_->setToolTip(hint);
}

} // namespace dewpoint::ui
