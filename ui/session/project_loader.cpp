// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/project_loader.h"

#include "core/session/session.h"
#include "ui/session/open_request.h"
#include "ui/text/error_sentence.h"

#include <utility>

namespace dewpoint::ui {

ProjectLoader::ProjectLoader(ProjectOpener opener, QObject* parent)
    : QObject(parent), opener_(std::move(opener)) {}

ProjectLoader::~ProjectLoader() = default;

bool ProjectLoader::isReopening() const {
  return wanted_ != nullptr && wanted_->keepHistory;
}

void ProjectLoader::open(OpenRequest request) {
  wanted_ = std::make_unique<OpenRequest>(std::move(request));
  if (!std::exchange(opening_, true)) {
    Q_EMIT openingChanged(true);
  }
  job_.start([this, opener = opener_, what = wanted_->what](const BackgroundJob::Progress&) {
    // What nobody wants any more is closed in a thread, too.
    const std::shared_ptr<Result<SessionInputs>> result(new Result<SessionInputs>(opener(what)),
                                                        DetachedDelete());
    return [this, result] { finish(result); };
  });
}

void ProjectLoader::finish(const std::shared_ptr<Result<SessionInputs>>& result) {
  opening_ = false;
  const std::unique_ptr<OpenRequest> request = std::move(wanted_);
  if (*result) {
    Q_EMIT opened(*request, std::make_shared<SessionInputs>(std::move(**result)));
  } else {
    Q_EMIT failed(errorSentence(result->error()));
  }
  Q_EMIT openingChanged(opening_);
}

void ProjectLoader::destroyInBackground(std::unique_ptr<Session> session) {
  if (session) {
    DetachedDelete()(session.release());
  }
}

} // namespace dewpoint::ui
