// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/selftest/self_test.h"
#include "ui/session/project_loader.h"

#include <QString>

#include <vector>

namespace dewpoint::ui {

/// Tests what only the window needs, and returns one line per test: the versions of Qt and VTK,
/// graphics, and languages. Takes about a second. Call this function in the GUI thread.
std::vector<SelfTestLine> runGraphicsSelfTest();

/// Returns the inputs of `runSelfTest()` for this computer. `opener` opens the demo, a built-in
/// scene.
SelfTestInputs makeSelfTestInputs(const ProjectOpener& opener);

/// Returns the lines as text, one per line.
QString selfTestReport(const std::vector<SelfTestLine>& lines);

/// Implements `dewpoint --self-test`: prints all results and returns the exit code, which is 1 if
/// there is a problem.
int printSelfTest(const ProjectOpener& opener);

} // namespace dewpoint::ui
