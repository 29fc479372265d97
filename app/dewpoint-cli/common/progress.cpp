// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/dewpoint-cli/common/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace dewpoint::app {
namespace {
constexpr int kBarWidth = 30;
constexpr std::chrono::milliseconds kRefresh{100};
} // namespace

Progress::Progress(std::string label, std::int64_t total)
    : label_(std::move(label)), total_(total), terminal_(isatty(STDERR_FILENO) != 0),
      begin_(std::chrono::steady_clock::now()) {}

void Progress::show(std::int64_t done) {
  const auto now = std::chrono::steady_clock::now();
  if (!terminal_ || (now - last_ < kRefresh && done != total_)) {
    return;
  }
  last_ = now;
  const std::chrono::duration<double> elapsed = now - begin_;
  const double rate = static_cast<double>(done) / std::max(1e-3, elapsed.count());
  if (total_ > 0) {
    const auto filled = static_cast<int>(kBarWidth * std::min(done, total_) / total_);
    fmt::print(stderr, "\r{} [{:=<{}}{: <{}}] {}/{}  {:.0f}/s ", label_, "", filled, "",
               kBarWidth - filled, done, total_, rate);
  } else {
    fmt::print(stderr, "\r{} {}  {:.0f}/s ", label_, done, rate);
  }
  std::fflush(stderr);
}

void Progress::finish() {
  if (terminal_) {
    fmt::print(stderr, "\r\033[K");
  }
}

} // namespace dewpoint::app
