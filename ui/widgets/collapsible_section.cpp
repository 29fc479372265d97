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
    : QWidget(parent), head_(new QToolButton(this)), mark_(new QLabel(QStringLiteral("●"), this)),
      body_(new QWidget(this)), rows_(new QVBoxLayout(body_)) {
  head_->setObjectName(QStringLiteral("sectionHead"));
  head_->setText(title);
  head_->setFont(headingFont(font()));
  head_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  head_->setAutoRaise(true);
  head_->setFocusPolicy(Qt::StrongFocus);
  head_->setIconSize({10, 10});
  mark_->setForegroundRole(QPalette::Highlight);
  mark_->setFont(smallerFont(font()));
  mark_->hide();
  rows_->setContentsMargins(0, kSpacing / 2, 0, kSpacing);
  rows_->setSpacing(2 * kSpacing);
  auto* heading = new QHBoxLayout;
  heading->setSpacing(kSpacing / 2);
  heading->addWidget(head_);
  heading->addWidget(mark_);
  heading->addStretch();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(heading);
  column->addWidget(body_);
  setOpen(false);
  connect(head_, &QToolButton::clicked, this, [this] {
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
  head_->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
}

void CollapsibleSection::setMark(const QString& hint) {
  mark_->setVisible(!hint.isEmpty());
  mark_->setToolTip(hint);
}

} // namespace dewpoint::ui
