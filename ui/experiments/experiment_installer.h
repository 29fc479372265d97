// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::ui {

struct Workbench;

/// Adds the dialog that reproduces the experiments in the papers.
void installExperiments(const Workbench& bench);

} // namespace dewpoint::ui
