// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_pages/describe_option.h"
#include "app/dewpoint/action_reference.h"
#include "app/dewpoint/run_output.h"
#include "app/dewpoint/screenshot.h"
#include "app/wiring/open_project.h"
#include "app/wiring/quiet_libraries.h"
#include "core/base/thread_priority.h"
#include "core/session/session.h"
#include "ui/document/recovery.h"
#include "ui/help/crash_reports.h"
#include "ui/help/window_self_test.h"
#include "ui/jobs/job_thread.h"
#include "ui/mainwindow/main_window.h"
#include "ui/preferences/preferences.h"
#include "ui/text/language.h"
#include "ui/view3d/birds_eye_view.h"

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QIcon>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace {

struct Options {
  std::string project;
  std::string out;
  std::string screenshot;
  int frames = 60;
  bool paused = false;
  std::string theme;
  std::string size;
  std::string language;
  bool listActions = false;
  bool selfTest = false;
};

std::vector<std::string> languageNames() {
  std::vector<std::string> names;
  for (const QString& language : dewpoint::ui::availableLanguages()) {
    names.push_back(language.toStdString());
  }
  return names;
}

bool isSize(const std::string& text, int& width, int& height) {
  return std::sscanf(text.c_str(), "%dx%d", &width, &height) == 2 && width >= 400 && height >= 300;
}

void describe(CLI::App& app, Options& options) {
  app.add_option(
      "project", options.project,
      "Project file, or a built-in scene (demo, converge, one-camera, still, smooth, fast, jump, "
      "look-alikes, occluder; office: people)");
  app.add_option("--out", options.out,
                 "Folder for trajectory.csv and run.json, written at the end and on quitting");
  app.add_option("--screenshot", options.screenshot, "Save the window as PNG, then quit");
  app.add_option("--frames", options.frames, "Frames to track before the screenshot")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_flag("--paused", options.paused, "Do not start playing");
  app.add_option("--theme", options.theme, "Colors")
      ->check(CLI::IsMember({"light", "dark", "system"}));
  app.add_option("--size", options.size, "Size of the window, like 1400x900")
      ->check([](const std::string& text) {
        int width = 0;
        int height = 0;
        return isSize(text, width, height) ? std::string()
                                           : std::string("give it as WIDTHxHEIGHT, from 400x300");
      });
  app.add_option("--language", options.language,
                 "Language of the window; if omitted, the language of the system")
      ->check(CLI::IsMember(languageNames()));
  app.add_flag("--list-actions", options.listActions,
               "Print all actions with their shortcuts as a page of the manual, then quit")
      ->group(""); // of use to script/manual only: --help does not list it
  app.add_flag("--self-test", options.selfTest,
               "Check what works on this computer, print the result, then quit; the exit code is 1 "
               "if there is a problem");
  app.set_version_flag("--version", DEWPOINT_VERSION);
  dewpoint::app::addDescribeOption(app, "dewpoint-cli");
}

/// Whether the command line only asks for a text, which needs no display.
bool asksForText(int argc, char** argv) {
  return std::any_of(argv + 1, argv + argc, [](std::string_view argument) {
    return argument == "--help" || argument == "-h" || argument == "--version" ||
           argument.starts_with("--describe");
  });
}

/// A self-test runs without a display, too: on Qt's offscreen platform, unless another is chosen.
void chooseSelfTestPlatform(int argc, char** argv) {
  const bool isWanted = std::any_of(argv, argv + argc, [](const char* argument) {
    return std::string_view(argument) == "--self-test";
  });
  const bool hasDisplay = qEnvironmentVariableIsSet("DISPLAY") ||
                          qEnvironmentVariableIsSet("WAYLAND_DISPLAY") ||
                          qEnvironmentVariableIsSet("QT_QPA_PLATFORM");
  if (isWanted && !hasDisplay) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
  }
}

int run(int argc, char** argv) {
  CLI::App app("Tracks colored objects in 3D with particle filters.", "dewpoint");
  Options options;
  describe(app, options);
  if (asksForText(argc, argv)) {
    CLI11_PARSE(app, argc, argv);
  }
  chooseSelfTestPlatform(argc, argv);
  dewpoint::base::setThreadPriority(
      dewpoint::base::ThreadPriority::Patient); // before any thread is made
  dewpoint::ui::BirdsEyeView::prepareSurfaceFormat();
  QApplication application(argc, argv); // takes its own options out of argv
  QApplication::setApplicationName(QStringLiteral("dewpoint"));
  QApplication::setOrganizationName(QStringLiteral("dewpoint"));
  QApplication::setApplicationVersion(QStringLiteral(DEWPOINT_VERSION));
  QApplication::setDesktopFileName(QStringLiteral("dewpoint"));
  QApplication::setWindowIcon(QIcon(QStringLiteral(":/icons/dewpoint.svg")));

  CLI11_PARSE(app, argc, argv);
  dewpoint::ui::useLanguage(options.language.empty() ? dewpoint::ui::Preferences().language()
                                                     : QString::fromStdString(options.language));
  if (options.listActions) {
    const QByteArray page = dewpoint::app::actionReference().toUtf8();
    std::fwrite(page.constData(), 1, static_cast<std::size_t>(page.size()), stdout);
    return 0;
  }
  if (options.selfTest) {
    return dewpoint::ui::printSelfTest(&dewpoint::app::openProject);
  }

  dewpoint::ui::enableCrashReports();
  const dewpoint::ui::Theme theme =
      options.theme.empty() ? dewpoint::ui::Preferences().theme()
                            : dewpoint::ui::themeFromName(QString::fromStdString(options.theme));
  std::optional<dewpoint::app::RunOutput> output; // goes after the window, when all is written
  dewpoint::ui::MainWindow window(&dewpoint::app::openProject);
  window.setTheme(theme);
  const bool unattended = !options.screenshot.empty() || !options.out.empty();
  if (!unattended) {
    window.restoreAndSaveGeometry();
  }
  int width = 0;
  int height = 0;
  if (isSize(options.size, width, height)) {
    window.resize(width, height);
  }
  window.setPlayOnOpen(!options.paused || !options.screenshot.empty());
  if (!options.screenshot.empty()) {
    dewpoint::app::takeScreenshot(window, QString::fromStdString(options.screenshot),
                                  options.frames);
  }
  if (!options.out.empty()) {
    output.emplace(window, options.out);
  }
  window.show();
  if (!unattended) {
    window.enableRecovery(dewpoint::ui::Recovery::standardFolder());
    window.offerCrashReports(dewpoint::ui::crashFolder());
  }
  if (unattended || !options.project.empty()) {
    window.openProject(options.project); // the demo when none is named
  }
  return QApplication::exec();
}

} // namespace

int main(int argc, char** argv) {
  dewpoint::app::silenceLibraries();
  try {
    const int code = run(argc, argv);
    if (!dewpoint::ui::waitForDetachedJobs(std::chrono::milliseconds(0))) {
      // A thread hangs in a dead camera or disk: the window is closed, and so is the program.
      std::fflush(nullptr);
      std::_Exit(code);
    }
    return code;
  } catch (const std::exception& error) {
    // Nothing below throws on purpose; this is memory running out and the like.
    std::fprintf(stderr, "dewpoint: stopped: %s.\n", error.what());
    return 1;
  }
}
