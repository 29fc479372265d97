// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/recording/take_comparison.h"

#include "core/base/thread_count.h"
#include "core/project/project.h"
#include "core/session/take/take_replay.h"
#include "ui/document/document.h"
#include "ui/preferences/preferences.h"
#include "ui/recording/take_text.h"
#include "ui/text/error_sentence.h"
#include "ui/widgets/message_bar.h"

#include <QMainWindow>

#include <memory>

namespace dewpoint::ui {

TakeComparison::TakeComparison(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), looking_(new JobQueue(this)),
      job_(new BackgroundJob(this)) {
  connect(&bench_.session, &SessionController::opened, this, &TakeComparison::offer);
  connect(&bench_.session, &SessionController::runEnded, this, [this] {
    job_->abandon();
    bench_.messages.withdrawQuestion(question_);
  });
  connect(&bench_.session, &SessionController::closed, this, [this] { offered_.clear(); });
}

void TakeComparison::offer() {
  const std::filesystem::path file = bench_.document.project().file;
  if (file.empty() || file == offered_) {
    return; // opened again with other cameras or settings
  }
  offered_ = file;
  looking_->add([this, file]() -> std::function<void()> {
    if (!hasLiveRun(file.parent_path())) {
      return {};
    }
    return [this, file] {
      if (bench_.document.project().file != file) {
        return; // another project was opened meanwhile
      }
      question_ = tr("This take contains the results of the live run.");
      bench_.messages.showLastingQuestion(
          question_, {{tr("Compare results"), [this, file] { compare(file.parent_path()); }}});
    };
  });
}

void TakeComparison::compare(const std::filesystem::path& take) {
  using Compared = Result<ReplayComparison>;
  const int threads = threadCountForFilter(Preferences().filterThreadCount());
  const bool starts = job_->start(
      [this, take, threads](const BackgroundJob::Progress& progress) -> std::function<void()> {
        const auto compared = std::make_shared<const Compared>(
            compareReplay(take, threads, [&](std::int64_t done, std::int64_t total) {
              return progress(total > 0 ? static_cast<double>(done) / static_cast<double>(total)
                                        : -1.0);
            }));
        return [this, compared] {
          if (!*compared) {
            bench_.messages.showError(errorText(compared->error()));
          } else if ((*compared)->isBitIdentical()) {
            bench_.messages.showQuestion(replayText(**compared), {});
          } else {
            bench_.messages.showWarning(replayText(**compared));
          }
        };
      });
  if (starts) {
    bench_.messages.showNotice(tr("Tracking the take again…"));
  }
}

} // namespace dewpoint::ui
