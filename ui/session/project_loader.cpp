// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/project_loader.h"

#include "core/session/session.h"
#include "core/setup/missing_files.h"
#include "ui/session/open_request.h"
#include "ui/text/error_sentence.h"

#include <utility>

namespace dewpoint::ui {

namespace {

/// The missing files of a project that cannot be opened; null if none is missing.
MissingFiles missingFilesOrNull(const SessionRequest& what) {
  auto missing = what.project ? Result<std::vector<MissingFile>>(missingFilesOf(*what.project))
                 : what.file.empty() ? Result<std::vector<MissingFile>>()
                                     : missingFilesOf(what.file, what.movedFiles);
  return missing && !missing->empty()
             ? std::make_shared<const std::vector<MissingFile>>(std::move(*missing))
             : nullptr;
}

} // namespace

ProjectLoader::ProjectLoader(ProjectOpener opener, QObject* parent)
    : QObject(parent), opener_(std::move(opener)) {}

ProjectLoader::~ProjectLoader() = default;

bool ProjectLoader::isReopening() const {
  return newestRequest_ != nullptr && newestRequest_->keepsHistory;
}

void ProjectLoader::open(OpenRequest request) {
  newestRequest_ = std::make_unique<OpenRequest>(std::move(request));
  if (!std::exchange(opening_, true)) {
    Q_EMIT openingChanged(true);
  }
  job_.start([this, opener = opener_,
              source = newestRequest_->sessionRequest](const BackgroundJob::Progress&) {
    // What nobody wants any more is closed in a thread, too.
    const std::shared_ptr<Result<SessionInputs>> result(new Result<SessionInputs>(opener(source)),
                                                        DetachedDeleter());
    const MissingFiles missing = *result ? nullptr : missingFilesOrNull(source);
    return [this, result, missing] { finish(result, missing); };
  });
}

void ProjectLoader::finish(const std::shared_ptr<Result<SessionInputs>>& result,
                           const MissingFiles& missing) {
  opening_ = false;
  const std::unique_ptr<OpenRequest> request = std::move(newestRequest_);
  if (*result) {
    Q_EMIT opened(*request, std::make_shared<SessionInputs>(std::move(**result)));
  } else {
    Q_EMIT failed(*request, errorText(result->error()), missing);
  }
  Q_EMIT openingChanged(opening_);
}

void ProjectLoader::destroyInBackground(std::unique_ptr<Session> session) {
  if (session) {
    DetachedDeleter()(session.release());
  }
}

} // namespace dewpoint::ui
