// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/window_test.h"
#include "ui/view3d/birds_eye_view.h"

namespace dewpoint::tests {

/// Runs a test class of the 3D view alone, in Qt's own style.
template <class Test> int runSceneTest(int argc, char** argv, const QString& /*name*/) {
  BirdsEyeView::prepareSurfaceFormat();
  QApplication application(argc, argv);
  QApplication::setStyle(QStringLiteral("Fusion"));
  Test test;
  return QTest::qExec(&test, argc, argv);
}

} // namespace dewpoint::tests
