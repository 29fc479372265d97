// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/view_buttons.h"

#include "ui/style/spacing.h"

#include <QToolButton>
#include <QWidget>

namespace dewpoint::ui {
namespace {

constexpr std::array<Scene3d::View, 3> kViews{Scene3d::View::Above, Scene3d::View::Front,
                                              Scene3d::View::Free};

} // namespace

ViewButtons::ViewButtons(QWidget& view) : QObject(&view), view_(view) {
  const std::array<QString, 3> names{QStringLiteral("lookFromAboveButton"),
                                     QStringLiteral("lookFromFrontButton"),
                                     QStringLiteral("lookFreeButton")};
  for (std::size_t i = 0; i < kViews.size(); ++i) {
    auto* button = new QToolButton(&view);
    button->setObjectName(names[i]);
    button->setCheckable(true);
    button->setAutoFillBackground(true);
    button->setCursor(Qt::ArrowCursor);
    connect(button, &QToolButton::clicked, this, [this, i] { Q_EMIT chosen(kViews[i]); });
    buttons_[i] = button;
  }
}

void ViewButtons::setCurrent(Scene3d::View view) {
  for (std::size_t i = 0; i < kViews.size(); ++i) {
    buttons_[i]->setChecked(view == kViews[i]);
  }
}

void ViewButtons::setShown(bool shown) {
  shown_ = shown;
  place();
}

void ViewButtons::place() {
  int x = kSpacing;
  for (QToolButton* button : buttons_) {
    const QSize size = button->sizeHint();
    button->setGeometry(QRect(QPoint(x, view_.height() - size.height() - kSpacing), size));
    button->setVisible(shown_);
    x += size.width() + kSpacing / 2;
  }
}

void ViewButtons::retranslate() {
  const std::array<QString, 3> texts{tr("Above"), tr("Front"), tr("Free")};
  const std::array<QString, 3> tips{
      tr("Look from above: X to the right, Y up. Drag to move, wheel to zoom, double click to see "
         "everything."),
      tr("Look from the front: X to the right, Z up. Drag to move, wheel to zoom, double click to "
         "see everything."),
      tr("Perspective. Drag to orbit, Shift and drag to move, wheel to zoom, double click to see "
         "everything.")};
  for (std::size_t i = 0; i < kViews.size(); ++i) {
    buttons_[i]->setText(texts[i]);
    buttons_[i]->setToolTip(tips[i]);
    buttons_[i]->setAccessibleDescription(tips[i]);
  }
  place();
}

} // namespace dewpoint::ui
