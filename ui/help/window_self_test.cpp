// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/window_self_test.h"

#include "core/setup/new_project/footage.h"
#include "ui/text/language.h"
#include "ui/view3d/gl_context.h"

#include <QCoreApplication>
#include <QDir>
#include <QGuiApplication>
#include <QLocale>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QStringList>

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>

namespace dewpoint::ui {

namespace {

constexpr std::array kSoftwareRenderers{"llvmpipe", "softpipe", "swrast", "SwiftShader",
                                        "Software Rasterizer"};

bool hasScreen() {
  return QGuiApplication::platformName() != QLatin1String("offscreen") &&
         QGuiApplication::platformName() != QLatin1String("minimal");
}

QString openGlName(QOpenGLFunctions& gl, unsigned int what) {
  return QString::fromUtf8(reinterpret_cast<const char*>(gl.glGetString(what)));
}

SelfTestLine openGlLine() {
  GlContext context;
  if (const std::string failure = context.start(); !failure.empty()) {
    return hasScreen() ? SelfTestLine{FindingLevel::Problem, "graphics", failure}
                       : SelfTestLine{FindingLevel::Note, "graphics",
                                      "not tried, there is no display: " + failure};
  }
  QOpenGLFunctions* gl = QOpenGLContext::currentContext()->functions();
  const QString renderer = openGlName(*gl, GL_RENDERER);
  QString text = QStringLiteral("%1, OpenGL %2").arg(renderer, openGlName(*gl, GL_VERSION));
  context.doneCurrent();
  const bool isSoftware = std::ranges::any_of(kSoftwareRenderers, [&](const char* name) {
    return renderer.contains(QLatin1String(name), Qt::CaseInsensitive);
  });
  text += isSoftware ? QStringLiteral("; drawn by the processor, which is slow") : QString();
  text += hasScreen() ? QString() : QStringLiteral("; not tried on a screen, there is no display");
  return {isSoftware || !hasScreen() ? FindingLevel::Note : FindingLevel::Ok, "graphics",
          text.toStdString()};
}

SelfTestLine languagesLine() {
  const QStringList all = availableLanguages();
  const QString text =
      QStringLiteral("%1; in use: %2 (system: %3)")
          .arg(all.join(QStringLiteral(", ")), QLocale().name(), QLocale::system().name());
  return {all.isEmpty() ? FindingLevel::Problem : FindingLevel::Ok, "languages",
          all.isEmpty() ? "no catalog was built in" : text.toStdString()};
}

} // namespace

std::vector<SelfTestLine> runGraphicsSelfTest() {
  const QString toolkit = QStringLiteral("Qt %1 (%2), VTK %3")
                              .arg(QString::fromLatin1(qVersion()), QGuiApplication::platformName(),
                                   QStringLiteral(DEWPOINT_VTK_VERSION));
  return {{FindingLevel::Ok, "window", toolkit.toStdString()}, openGlLine(), languagesLine()};
}

SelfTestInputs makeSelfTestInputs(const ProjectOpener& opener) {
  SelfTestInputs parts;
  parts.openScene = [opener] { return opener(SessionRequest("demo")); };
  parts.cameraNames = connectedCameras();
  parts.scratchFolder =
      QDir::temp()
          .filePath(QStringLiteral("dewpoint-self-test-%1").arg(QCoreApplication::applicationPid()))
          .toStdString();
  return parts;
}

QString selfTestReport(const std::vector<SelfTestLine>& lines) {
  QStringList texts;
  std::ranges::transform(lines, std::back_inserter(texts), [](const SelfTestLine& line) {
    return QString::fromStdString(selfTestText(line));
  });
  return texts.join(QLatin1Char('\n'));
}

int printSelfTest(const ProjectOpener& opener) {
  std::vector<SelfTestLine> lines = runGraphicsSelfTest();
  std::ranges::move(runSelfTest(makeSelfTestInputs(opener)), std::back_inserter(lines));
  std::printf("%s\n", qUtf8Printable(selfTestReport(lines)));
  return worstLevelOf(lines) == FindingLevel::Problem ? 1 : 0;
}

} // namespace dewpoint::ui
