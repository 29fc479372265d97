// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/project_loader.h"

#include "core/session/session.h"
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

void ProjectLoader::open(SessionRequest request) {
  if (opening_) {
    next_ = std::make_unique<SessionRequest>(std::move(request));
    return;
  }
  opening_ = true;
  Q_EMIT openingChanged(true);
  worker_ = std::jthread([this, request = std::move(request)] {
    auto result = std::make_shared<Result<SessionInputs>>(opener_(request));
    QMetaObject::invokeMethod(
        this, [this, result] { finish(result); }, Qt::QueuedConnection);
  });
}

void ProjectLoader::finish(const std::shared_ptr<Result<SessionInputs>>& result) {
  opening_ = false;
  if (next_) {
    const std::unique_ptr<SessionRequest> next = std::move(next_);
    open(std::move(*next));
    return;
  }
  if (*result) {
    Q_EMIT opened(std::make_shared<SessionInputs>(std::move(**result)));
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
