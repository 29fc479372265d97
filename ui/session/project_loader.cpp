// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/project_loader.h"

#include "core/session/session.h"
#include "ui/session/open_request.h"
#include "ui/text/error_sentence.h"

#include <QMetaObject>

namespace dewpoint::ui {

ProjectLoader::ProjectLoader(ProjectOpener opener, QObject* parent)
    : QObject(parent), opener_(std::move(opener)) {}

ProjectLoader::~ProjectLoader() {
  // Before QObject goes: the worker posts to it.
  if (worker_.joinable()) {
    worker_.join();
  }
}

bool ProjectLoader::isReopening() const {
  const OpenRequest* last = next_ ? next_.get() : now_.get();
  return last != nullptr && last->keepHistory;
}

void ProjectLoader::open(OpenRequest request) {
  if (opening_) {
    next_ = std::make_unique<OpenRequest>(std::move(request));
    return;
  }
  now_ = std::make_unique<OpenRequest>(std::move(request));
  opening_ = true;
  Q_EMIT openingChanged(true);
  worker_ = std::jthread([this, what = now_->what] {
    auto result = std::make_shared<Result<SessionInputs>>(opener_(what));
    QMetaObject::invokeMethod(
        this, [this, result] { finish(result); }, Qt::QueuedConnection);
  });
}

void ProjectLoader::finish(const std::shared_ptr<Result<SessionInputs>>& result) {
  opening_ = false;
  const std::unique_ptr<OpenRequest> request = std::move(now_);
  if (next_) {
    const std::unique_ptr<OpenRequest> next = std::move(next_);
    open(std::move(*next));
    return;
  }
  if (*result) {
    Q_EMIT opened(*request, std::make_shared<SessionInputs>(std::move(**result)));
  } else {
    Q_EMIT failed(errorSentence(result->error()));
  }
  Q_EMIT openingChanged(false);
}

void ProjectLoader::retire(std::unique_ptr<Session> session) {
  if (session) {
    retirement_ = std::jthread([old = std::move(session)]() mutable { old.reset(); });
  }
}

} // namespace dewpoint::ui
