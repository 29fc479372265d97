// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/action_button.h"

#include <QAction>
#include <QToolButton>

namespace dewpoint::ui {

QToolButton* makeActionButton(const char* name, QAction* action, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setObjectName(QLatin1String(name));
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setIconSize({16, 16});
  button->setFocusPolicy(Qt::StrongFocus);
  const auto follow = [button, action] {
    button->setCheckable(action->isCheckable());
    button->setChecked(action->isChecked());
    button->setEnabled(action->isEnabled());
    button->setIcon(action->icon());
    button->setToolTip(action->toolTip());
  };
  follow();
  QObject::connect(action, &QAction::changed, button, follow);
  QObject::connect(button, &QToolButton::clicked, action, [action, follow] {
    action->trigger();
    follow(); // also where the action stayed as it was
  });
  return button;
}

} // namespace dewpoint::ui
