// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/color/color_choice.h"

#include "ui/style/range_color.h"

#include <QButtonGroup>
#include <QColor>
#include <QHBoxLayout>
#include <QIcon>
#include <QPainter>
#include <QPixmap>
#include <QToolButton>

namespace dewpoint::ui {

namespace {

QIcon swatchOf(const QColor& color, const QWidget& widget) {
  const int side = widget.fontMetrics().height();
  const qreal ratio = widget.devicePixelRatioF();
  QPixmap pixmap(QSize(side, side) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(widget.palette().color(QPalette::Mid));
  painter.setBrush(color);
  painter.drawEllipse(QRectF(1.5, 1.5, side - 3.0, side - 3.0));
  return pixmap;
}

} // namespace

ColorChoice::ColorChoice(QWidget* parent)
    : QWidget(parent), group_(new QButtonGroup(this)), row_(new QHBoxLayout(this)),
      remove_(new QToolButton(this)) {
  setObjectName(QStringLiteral("colorChoice"));
  remove_->setObjectName(QStringLiteral("colorRemove"));
  remove_->setFocusPolicy(Qt::StrongFocus);
  row_->setContentsMargins(0, 0, 0, 0);
  row_->setSpacing(4);
  row_->addStretch(1);
  row_->addWidget(remove_);
  connect(remove_, &QToolButton::clicked, this, [this] { Q_EMIT removeRequested(chosen_); });
  connect(group_, &QButtonGroup::idClicked, this, [this](int id) {
    if (id != chosen_) {
      chosen_ = id;
      Q_EMIT selectedColorChanged();
    }
  });
  hide();
}

void ColorChoice::setColors(const ColorRanges& colors) {
  if (colors.size() != colors_.size()) {
    chosen_ = 0;
  }
  colors_ = colors;
  updateButtons();
}

void ColorChoice::updateButtons() {
  const std::size_t count = colors_.size() > 1 ? colors_.size() : 0;
  while (buttons_.size() < count) {
    auto* button = new QToolButton(this);
    const auto index = static_cast<int>(buttons_.size());
    button->setObjectName(QStringLiteral("color%1").arg(index + 1));
    button->setCheckable(true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    group_->addButton(button, index);
    row_->insertWidget(index, button);
    buttons_.push_back(button);
  }
  for (std::size_t k = 0; k < buttons_.size(); ++k) {
    buttons_[k]->setVisible(k < count);
    if (k < count) {
      buttons_[k]->setText(tr("Color %1").arg(k + 1));
      buttons_[k]->setToolTip(tr("Show this color, so that its range can be changed by hand"));
      buttons_[k]->setIcon(swatchOf(rangeColor(colors_[k]), *this));
      buttons_[k]->setChecked(static_cast<int>(k) == chosen_);
    }
  }
  setVisible(count > 0);
}

void ColorChoice::retranslateUi() {
  setAccessibleName(tr("Colors of the target"));
  remove_->setText(tr("Remove"));
  remove_->setToolTip(tr("Remove this color from the target, and the samples that show it"));
  updateButtons();
}

} // namespace dewpoint::ui
