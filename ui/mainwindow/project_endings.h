// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <QString>

namespace dewpoint::ui {

/// Returns whether a file name has the suffix of a project.
bool isProjectFile(const QString& file);
/// Returns a file dialog filter in which *.toml is replaced by all project suffixes.
QString withAllProjectSuffixes(QString filter);

} // namespace dewpoint::ui
