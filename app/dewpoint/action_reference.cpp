// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint/action_reference.h"

#include "ui/actions/action_registry.h"
#include "ui/actions/window_actions.h"

#include <QAction>
#include <QWidget>

namespace dewpoint::app {

QString actionReference() {
  QWidget window;
  ui::ActionRegistry registry(&window);
  ui::declareWindowActions(registry);
  QString page = QStringLiteral(
      "# Actions and keyboard shortcuts\n\n"
      "Every action of the window, as the program declares it. Ctrl+K finds an action by its "
      "name. Change a shortcut with *Edit › Shortcuts…*; keys of single views are described with "
      "them in [The window](window.md).\n");
  QString group;
  for (const QAction* action : registry.allActions()) {
    if (registry.groupOf(action) != group) {
      group = registry.groupOf(action);
      page += QStringLiteral("\n## %1\n\n| action | key | what it does |\n| --- | --- | --- |\n")
                  .arg(group);
    }
    const QString keys = registry.defaultShortcut(action).toString(QKeySequence::PortableText);
    page += QStringLiteral("| %1 | %2 | %3 |\n")
                .arg(action->text(), keys.isEmpty() ? QString() : QStringLiteral("`%1`").arg(keys),
                     registry.hintOf(action));
  }
  return page;
}

} // namespace dewpoint::app
