// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/project_endings.h"

namespace dewpoint::ui {

bool isProjectFile(const QString& file) {
  // The second ending is what a double click on a desktop goes by.
  return file.endsWith(QStringLiteral(".toml"), Qt::CaseInsensitive) ||
         file.endsWith(QStringLiteral(".dewpoint"), Qt::CaseInsensitive);
}

QString withAllProjectSuffixes(QString filter) {
  return filter.replace(QStringLiteral("*.toml"), QStringLiteral("*.toml *.dewpoint"));
}

} // namespace dewpoint::ui
