// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/view3d/view_buttons.h"

#include "ui/style/spacing.h"
#include "ui/view3d/scene_inset.h"

#include <QToolButton>
#include <QWidget>

namespace dewpoint::ui {
namespace {

constexpr std::array<Scene3d::View, 4> kViews{Scene3d::View::Free, Scene3d::View::Above,
                                              Scene3d::View::Front, Scene3d::View::Side};

QToolButton* pictureButton(QWidget& view, const QString& name) {
  auto* button = new QToolButton(&view);
  button->setObjectName(name);
  button->setAutoFillBackground(true);
  button->setCursor(Qt::ArrowCursor);
  return button;
}

} // namespace

ViewButtons::ViewButtons(QWidget& view) : QObject(&view), view_(view) {
  const std::array<QString, 4> names{
      QStringLiteral("lookFreeButton"), QStringLiteral("lookFromAboveButton"),
      QStringLiteral("lookFromFrontButton"), QStringLiteral("lookFromSideButton")};
  for (std::size_t i = 0; i < kViews.size(); ++i) {
    buttons_[i] = pictureButton(view, names[i]);
    buttons_[i]->setCheckable(true);
    connect(buttons_[i], &QToolButton::clicked, this, [this, i] { Q_EMIT viewChosen(kViews[i]); });
  }
  fit_ = pictureButton(view, QStringLiteral("fitSceneButton"));
  connect(fit_, &QToolButton::clicked, this, &ViewButtons::fitRequested);
}

void ViewButtons::setCurrentView(Scene3d::View view) {
  for (std::size_t i = 0; i < kViews.size(); ++i) {
    buttons_[i]->setChecked(view == kViews[i]);
  }
}

void ViewButtons::setShown(bool shown) {
  shown_ = shown;
  moveToCorner();
}

void ViewButtons::moveToCorner() {
  int x = kSpacing;
  int above = kSpacing; // the lower border of the view
  const double end = SceneInset::fitsInView(view_) ? SceneInset::usualArea(view_).left()
                                                   : view_.width() - kSpacing;
  const auto put = [&](QToolButton* button) {
    const QSize size = button->sizeHint();
    if (x > kSpacing && x + size.width() > end) { // words are long in some languages
      x = kSpacing;
      above += size.height() + kSpacing / 2;
    }
    button->setGeometry(QRect(QPoint(x, view_.height() - size.height() - above), size));
    button->setVisible(shown_);
    x += size.width() + kSpacing / 2;
  };
  for (QToolButton* button : buttons_) {
    put(button);
  }
  x += kSpacing; // it chooses no view
  put(fit_);
}

void ViewButtons::retranslateUi() {
  const std::array<QString, 4> texts{tr("3D"), tr("Top"), tr("Front"), tr("Side")};
  const std::array<QString, 4> tips{
      tr("Perspective view. Drag to orbit, Shift-drag to move, scroll to zoom, double-click to "
         "show "
         "everything."),
      tr("View from above: X to the right, Y up. Drag to move, scroll to zoom, double-click to "
         "show everything."),
      tr("View from the front: X to the right, Z up. Drag to move, scroll to zoom, double-click to "
         "show everything."),
      tr("View from the side: Y to the right, Z up. Drag to move, scroll to zoom, double-click to "
         "show everything.")};
  for (std::size_t i = 0; i < kViews.size(); ++i) {
    buttons_[i]->setText(texts[i]);
    buttons_[i]->setToolTip(tips[i]);
    buttons_[i]->setAccessibleDescription(tips[i]);
  }
  fit_->setText(tr("Fit"));
  fit_->setToolTip(
      tr("Fit everything in the view without changing the viewing direction (or double-click)"));
  fit_->setAccessibleDescription(fit_->toolTip());
  moveToCorner();
}

} // namespace dewpoint::ui
