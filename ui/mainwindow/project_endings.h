// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

namespace dewpoint::ui {

/// Whether a file is a project by its ending.
bool isProject(const QString& file);
/// A filter of a file dialog that names *.toml, with all endings of projects.
QString withAllEndings(QString filter);

} // namespace dewpoint::ui
