// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/selftest/self_test.h"
#include "ui/session/project_loader.h"

#include <QString>

#include <vector>

namespace dewpoint::ui {

/// Tries what the window alone needs: versions of Qt and VTK, graphics, languages. In the window's
/// thread; takes a moment.
std::vector<SelfTestLine> graphicsSelfTest();

/// What runSelfTest() uses on this computer; `opener` opens the demo.
SelfTestParts selfTestParts(const ProjectOpener& opener);

/// The lines as text, one below the other.
QString selfTestReport(const std::vector<SelfTestLine>& lines);

/// `dewpoint --self-test`: prints everything; returns what the process returns, 1 with a problem.
int printSelfTest(const ProjectOpener& opener);

} // namespace dewpoint::ui
