// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/calibration_dock.h"

#include "ui/actions/action_registry.h"
#include "ui/text/retranslation.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QProgressBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabWidget>
#include <QTimer>
#include <QVBoxLayout>

namespace dewpoint::ui {

CalibrationDock::CalibrationDock(QWidget* parent) : QWidget(parent), tabs_(new QTabWidget(this)) {
  setObjectName(QStringLiteral("calibrationPlace"));
  setProperty(kKeepsKeys, true);
  tabs_->setObjectName(QStringLiteral("calibrationPages"));
  tabs_->setDocumentMode(true);
  tabs_->setTabBarAutoHide(true);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(tabs_);
  onRetranslate(this, [this] { tabs_->setAccessibleName(tr("Pages of the camera calibration")); });
  connect(tabs_, &QTabWidget::currentChanged, this, [this] { Q_EMIT pageChanged(shownPage()); });
}

void CalibrationDock::addPage(QWidget* page, const std::function<QString()>& title) {
  auto* scroll = new QScrollArea(tabs_);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidget(page);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // it is wide enough, see below
  page->installEventFilter(this);
  tabs_->addTab(scroll, QString());
  for (QWidget* part : page->findChildren<QWidget*>()) {
    if (qobject_cast<QProgressBar*>(part) != nullptr ||
        part->property(kRevealedProperty).toBool()) {
      part->installEventFilter(this);
    }
  }
  for (QComboBox* choice : page->findChildren<QComboBox*>()) {
    choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    if (choice->minimumContentsLength() == 0) {
      choice->setMinimumContentsLength(8); // long words are seen in the list
    }
  }
  for (QWidget* field : page->findChildren<QWidget*>()) {
    if (qobject_cast<QComboBox*>(field) != nullptr ||
        qobject_cast<QAbstractSpinBox*>(field) != nullptr ||
        qobject_cast<QAbstractSlider*>(field) != nullptr) {
      field->setFocusPolicy(field->focusPolicy() == Qt::NoFocus ? Qt::NoFocus : Qt::StrongFocus);
      field->installEventFilter(this);
    }
  }
  onRetranslate(scroll,
                [this, scroll, title] { tabs_->setTabText(tabs_->indexOf(scroll), title()); });
}

void CalibrationDock::setHeader(QWidget* header) {
  static_cast<QVBoxLayout*>(layout())->insertWidget(0, header);
}

bool CalibrationDock::eventFilter(QObject* watched, QEvent* event) {
  if (auto* part = qobject_cast<QWidget*>(watched); part != nullptr &&
                                                    event->type() == QEvent::Show &&
                                                    (qobject_cast<QProgressBar*>(part) != nullptr ||
                                                     part->property(kRevealedProperty).toBool())) {
    // What has just begun or ended is brought into view, once it has its place.
    QTimer::singleShot(0, part, [this, part] {
      if (auto* scroll = qobject_cast<QScrollArea*>(tabs_->currentWidget());
          scroll != nullptr && scroll->isAncestorOf(part) && part->isVisible()) {
        scroll->ensureWidgetVisible(part);
      }
    });
  }
  if (event->type() == QEvent::LayoutRequest) {
    adjustWidth();
  }
  const auto* field = qobject_cast<QWidget*>(watched);
  const bool isBar = qobject_cast<QScrollBar*>(watched) != nullptr;
  if (event->type() == QEvent::Wheel && field != nullptr && !field->hasFocus() && !isBar) {
    event->ignore();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void CalibrationDock::adjustWidth() {
  for (int k = 0; k < tabs_->count(); ++k) {
    auto* scroll = static_cast<QScrollArea*>(tabs_->widget(k));
    scroll->setMinimumWidth(scroll->widget()->minimumSizeHint().width() +
                            scroll->verticalScrollBar()->sizeHint().width());
  }
  // The scroll area of the view is as wide as the pages: otherwise their scroll bars would be out
  // of sight at its right.
  QWidget* const viewport = parentWidget();
  if (auto* view =
          qobject_cast<QScrollArea*>(viewport != nullptr ? viewport->parentWidget() : nullptr)) {
    view->setMinimumWidth(layout()->minimumSize().width());
  }
}

void CalibrationDock::showPage(const QString& name) {
  for (int k = 0; k < tabs_->count(); ++k) {
    if (static_cast<QScrollArea*>(tabs_->widget(k))->widget()->objectName() == name) {
      tabs_->setCurrentIndex(k);
    }
  }
}

QString CalibrationDock::shownPage() const {
  const auto* scroll = static_cast<QScrollArea*>(tabs_->currentWidget());
  return scroll != nullptr ? scroll->widget()->objectName() : QString();
}

} // namespace dewpoint::ui
