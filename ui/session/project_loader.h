// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"

#include <QObject>

#include <functional>
#include <memory>
#include <thread>

namespace dewpoint::session {
class Session;
struct SessionInputs;
struct SessionRequest;
} // namespace dewpoint::session

namespace dewpoint::ui {

/// Opens a project as the application wires it. Called in a thread.
using ProjectOpener = std::function<Result<SessionInputs>(const SessionRequest&)>;

/// Does what may take long, opening videos and joining threads, away from the window's thread.
class ProjectLoader : public QObject {
  Q_OBJECT
public:
  explicit ProjectLoader(ProjectOpener opener, QObject* parent = nullptr);
  ~ProjectLoader() override;

  /// Starts opening. While an opening is under way: the last of those asked for comes next, and
  /// what is under way is dropped.
  void open(SessionRequest request);
  /// For others that open a project in a thread of theirs.
  const ProjectOpener& opener() const { return opener_; }
  bool isOpening() const { return opening_; }
  /// Lets a session end in a thread of its own.
  void retire(std::unique_ptr<Session> session);

Q_SIGNALS:
  void openingChanged(bool opening);
  /// The inputs are the receiver's to move from.
  void opened(std::shared_ptr<SessionInputs> inputs);
  void failed(const QString& sentence);

private:
  void finish(const std::shared_ptr<Result<SessionInputs>>& result);

  ProjectOpener opener_;
  bool opening_ = false;
  std::unique_ptr<SessionRequest> next_;
  std::jthread worker_;
  std::jthread retirement_;
};

} // namespace dewpoint::ui
