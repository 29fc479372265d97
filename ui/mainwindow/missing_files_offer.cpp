// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/missing_files_offer.h"

#include "core/setup/missing_files.h"
#include "ui/session/open_request.h"
#include "ui/widgets/file_choice.h"
#include "ui/widgets/message_bar.h"

#include <QMainWindow>

#include <algorithm>
#include <utility>

namespace dewpoint::ui {

namespace {

constexpr std::size_t kMostNamed = 6; ///< of the missing files, in the message

QString nameOf(const MissingFile& file) {
  return QString::fromStdString(file.path.filename().string());
}

QString described(const MissingFile& file) {
  return file.cameraName.empty()
             ? nameOf(file)
             : MissingFilesOffer::tr("%1 (%2)", "a file, the name of its camera")
                   .arg(nameOf(file),
                        QStringLiteral("'%1'").arg(QString::fromStdString(file.cameraName)));
}

QString sentenceAbout(const std::vector<MissingFile>& missing) {
  if (missing.size() == 1) {
    return MissingFilesOffer::tr("%1 was not found in %2.")
        .arg(described(missing.front()),
             QString::fromStdString(missing.front().path.parent_path().string()));
  }
  QStringList names;
  for (std::size_t k = 0; k < std::min(missing.size(), kMostNamed); ++k) {
    names.append(described(missing[k]));
  }
  if (missing.size() > kMostNamed) {
    names.append(QStringLiteral("…"));
  }
  return MissingFilesOffer::tr("%n files of this project were not found: %1.", nullptr,
                               static_cast<int>(missing.size()))
      .arg(names.join(QStringLiteral(", ")));
}

} // namespace

MissingFilesOffer::MissingFilesOffer(const Workbench& bench)
    : QObject(&bench.window), bench_(bench) {
  connect(&bench_.session, &SessionController::filesMissing, this, &MissingFilesOffer::offer);
}

void MissingFilesOffer::offer(const OpenRequest& request, const MissingFiles& missing) {
  bench_.messages.showQuestion(sentenceAbout(*missing), {{tr("Locate…"), [this, request, missing] {
                                                            locate(request, missing);
                                                          }}});
}

void MissingFilesOffer::locate(const OpenRequest& request, const MissingFiles& missing) {
  const MissingFile& wanted = missing->front();
  const QString title = tr("Locate %1").arg(described(wanted));
  const QString found = wanted.isFolder() ? askForFolder(&bench_.window, title)
                                          : askForFile(&bench_.window, title, tr("All files (*)"));
  if (found.isEmpty()) {
    offer(request, missing);
    return;
  }
  OpenRequest again = request;
  const MovedFiles moved = locateRemainingFiles(*missing, wanted, found.toStdString());
  if (again.sessionRequest.project) {
    again.sessionRequest.project = withMovedFiles(std::move(*again.sessionRequest.project), moved);
  } else {
    again.sessionRequest.movedFiles.insert(moved.begin(), moved.end());
  }
  again.isUnsaved = true;
  again.message = tr("The project was opened with the files that you located. Save the project to "
                     "keep their new paths.");
  bench_.session.open(std::move(again));
}

} // namespace dewpoint::ui
