// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/help_installer.h"

#include "core/project/project.h"
#include "ui/actions/action_registry.h"
#include "ui/document/document.h"
#include "ui/help/about_dialog.h"
#include "ui/help/manual_pages.h"
#include "ui/help/manual_window.h"
#include "ui/help/message_history.h"
#include "ui/help/overlay_legend.h"
#include "ui/help/problem_report.h"
#include "ui/help/project_check_dialog.h"
#include "ui/help/quick_start.h"
#include "ui/widgets/message_bar.h"
#include "ui/workbench/view_dock.h"
#include "ui/workbench/workbench.h"

#include <QApplication>
#include <QMainWindow>

#include <algorithm>

namespace dewpoint::ui {

namespace {

constexpr qsizetype kReportedMessages = 30; ///< in a problem report

/// The one window of this kind, made when there is none, in front.
template <class Dialog, class Make> Dialog* presentOne(const Workbench& bench, const Make& make) {
  auto* dialog = bench.window.findChild<Dialog*>();
  if (dialog == nullptr) {
    dialog = make();
    dialog->setAttribute(Qt::WA_DeleteOnClose);
  }
  Workbench::presentDialog(dialog);
  return dialog;
}

void showManual(const Workbench& bench, const QString& page) {
  const QStringList folders = manualFolders();
  auto* manual = presentOne<ManualWindow>(
      bench, [&] { return new ManualWindow(findManual(folders), folders.front(), &bench.window); });
  manual->showPage(page);
}

QStringList lastMessages(const Workbench& bench) {
  const QStringList& all = bench.messages.recentMessages();
  return all.mid(std::max<qsizetype>(0, all.size() - kReportedMessages));
}

QString projectText(const Workbench& bench) {
  const Project& project = bench.document.project();
  return bench.session.isRunning() ? QStringLiteral("%1 cameras, %2 targets, method %3")
                                         .arg(project.cameras.size())
                                         .arg(project.targets.size())
                                         .arg(QString::fromStdString(project.method))
                                   : QStringLiteral("none is open");
}

} // namespace

void openCrashReportDialog(const Workbench& bench, const QString& crash) {
  auto* report = new ProblemReport({lastMessages(bench), projectText(bench), crash},
                                   bench.session.opener(), &bench.window);
  report->setAttribute(Qt::WA_DeleteOnClose);
  Workbench::presentDialog(report);
}

QString manualPageForFocusedView(const Workbench& bench) {
  const QString method = QString::fromStdString(bench.document.project().method);
  for (const QWidget* part = QApplication::focusWidget(); part != nullptr;
       part = part->parentWidget()) {
    if (qobject_cast<const ViewDock*>(part) != nullptr) {
      return manualPageOf(part->objectName(), method);
    }
  }
  return bench.session.isRunning() ? manualPageOf({}, method) : manualPages().front();
}

void installHelp(const Workbench& bench) {
  QObject* window = &bench.window;
  bench.onTriggered("actionManual", window,
                    [bench] { showManual(bench, manualPageForFocusedView(bench)); });
  bench.onTriggered("actionMethods", window, [bench] {
    showManual(bench, manualPageOfMethod(QString::fromStdString(bench.document.project().method)));
  });
  bench.onTriggered("actionQuickStart", window, [bench] {
    presentOne<QuickStart>(bench, [&] {
      return new QuickStart({bench.action("actionNew"), bench.action("actionCalibrate"),
                             bench.action("actionPlay"), bench.action("actionExportTrajectory"),
                             bench.action("actionLegend"), bench.action("actionManual")},
                            &bench.window);
    });
  });
  bench.onTriggered("actionLegend", window, [bench] {
    presentOne<OverlayLegend>(bench, [&] { return new OverlayLegend(&bench.window); });
  });
  bench.onTriggered("actionMessages", window, [bench] {
    presentOne<MessageHistory>(bench,
                               [&] { return new MessageHistory(bench.messages, &bench.window); });
  });
  bench.onTriggered("actionReportProblem", window, [bench] {
    presentOne<ProblemReport>(bench, [&] {
      return new ProblemReport({lastMessages(bench), projectText(bench), {}},
                               bench.session.opener(), &bench.window);
    });
  });
  bench.onTriggered("actionCheckProject", window, [bench] {
    presentOne<ProjectCheckDialog>(bench, [&] {
      return new ProjectCheckDialog([bench] { return bench.document.project(); },
                                    bench.session.opener(), &bench.window);
    });
  });
  bench.requireRun({"actionCheckProject"});
  bench.onTriggered("actionAbout", window, [bench] {
    presentOne<AboutDialog>(bench, [&] { return new AboutDialog(&bench.window); });
  });
}

} // namespace dewpoint::ui
