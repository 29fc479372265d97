// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/mainwindow/run_writer.h"

#include "core/session/session.h"
#include "ui/text/error_sentence.h"
#include "ui/widgets/message_bar.h"

#include <QMainWindow>

#include <memory>
#include <utility>

namespace dewpoint::ui {

RunWriter::RunWriter(const Workbench& bench) : QObject(&bench.window), bench_(bench) {}

void RunWriter::write(const std::filesystem::path& folder, std::function<void(bool)> written) {
  const Session* session = bench_.session.session();
  if (session == nullptr) {
    if (written) {
      written(false);
    }
    return;
  }
  const auto run = std::make_shared<const RunRecord>(session->record());
  queue_.add([this, run, folder, written = std::move(written)]() -> std::function<void()> {
    const Status saved = run->save(folder);
    if (written) {
      written(saved.has_value());
    }
    if (saved) {
      return {};
    }
    return [this, error = saved.error()] { bench_.messages.showError(errorText(error)); };
  });
}

} // namespace dewpoint::ui
