// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QStringList>

namespace dewpoint::ui {

/// Project files that were opened or saved last, the newest first; those that are gone are left
/// out. Belongs to the person, not to a project.
QStringList recentProjects();
void addRecentProject(const QString& file);
void clearRecentProjects();

} // namespace dewpoint::ui
