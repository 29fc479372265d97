// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <CLI/App.hpp>

namespace dewpoint::app {

/// `track-box`, see commands.h.
void addTrackBoxCommand(CLI::App& app, int& exitCode);
/// `sugandi-rmse`, into the group `experiment`.
void addSugandiExperiment(CLI::App& group, int& exitCode);

} // namespace dewpoint::app
