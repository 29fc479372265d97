// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/crash_report.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <execinfo.h>
#include <fcntl.h>
#include <mutex>
#include <unistd.h>
#include <utility>

namespace dewpoint::base {
namespace {

// A signal handler may neither allocate memory nor lock: all that it needs is reserved here.
struct Note {
  std::array<char, kCrashNoteLength> text{};
  std::size_t length = 0;
};
struct Notes {
  std::mutex mutex; // of those who note; the handler reads without it, since nobody may go on
  std::array<Note, kCrashNotes> ring{};
  std::size_t count = 0;
};
Notes& notes() {
  static Notes theNotes;
  return theNotes;
}

constexpr std::size_t kLongestPath = 4096;
constexpr std::size_t kLongestHeading = 1024;
constexpr int kMostFrames = 64;
/// Enough for the handler; MINSIGSTKSZ is no constant everywhere.
constexpr std::size_t kHandlerStack = std::size_t{64} * 1024;
constexpr std::array kCrashSignals{std::pair(SIGSEGV, "SIGSEGV: access to invalid memory"),
                                   std::pair(SIGABRT, "SIGABRT: the program gave up"),
                                   std::pair(SIGBUS, "SIGBUS: access to invalid memory"),
                                   std::pair(SIGFPE, "SIGFPE: arithmetic error"),
                                   std::pair(SIGILL, "SIGILL: invalid instruction")};

struct Target {
  std::array<char, kLongestPath> path{};
  std::array<char, kLongestHeading> heading{};
  std::array<char, kHandlerStack> stack{};
};
Target& target() {
  static Target theTarget;
  return theTarget;
}

void writeAll(int file, const char* text, std::size_t length) {
  while (length > 0) {
    const ssize_t written = ::write(file, text, length);
    if (written <= 0) {
      return; // a full disk: what is written stays
    }
    text += written;
    length -= static_cast<std::size_t>(written);
  }
}

void writeAll(int file, const char* text) {
  writeAll(file, text, std::strlen(text));
}

const char* nameOf(int signal) {
  for (const auto& [number, name] : kCrashSignals) {
    if (number == signal) {
      return name;
    }
  }
  return "unknown signal";
}

void writeNotes(int file) {
  const Notes& kept = notes();
  const std::size_t first = kept.count > kCrashNotes ? kept.count - kCrashNotes : 0;
  for (std::size_t k = first; k < kept.count; ++k) {
    const Note& note = kept.ring[k % kCrashNotes];
    writeAll(file, note.text.data(), std::min(note.length, kCrashNoteLength));
    writeAll(file, "\n");
  }
}

extern "C" void writeCrashReport(int signal) {
  const int file = ::open(target().path.data(), O_CREAT | O_WRONLY | O_TRUNC | O_CLOEXEC, 0600);
  if (file >= 0) {
    writeAll(file, target().heading.data());
    writeAll(file, "\n");
    writeAll(file, nameOf(signal));
    writeAll(file, "\n\nLast actions and messages:\n");
    writeNotes(file);
    writeAll(file, "\nStack:\n");
    std::array<void*, kMostFrames> frames{};
    ::backtrace_symbols_fd(frames.data(), ::backtrace(frames.data(), kMostFrames), file);
    ::close(file);
  }
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

} // namespace

void addCrashReportNote(std::string_view note) {
  Notes& kept = notes();
  const std::lock_guard lock(kept.mutex);
  Note& into = kept.ring[kept.count % kCrashNotes];
  into.length = std::min(note.size(), kCrashNoteLength);
  std::copy_n(note.begin(), into.length, into.text.begin());
  ++kept.count;
}

Status enableCrashReport(const std::filesystem::path& file, std::string_view heading) {
  std::error_code failed;
  std::filesystem::create_directories(file.parent_path(), failed);
  const std::string path = file.string();
  if (failed || path.size() >= kLongestPath) {
    return failure(ErrorCode::FileUnwritable, path, "",
                   failed ? failed.message() : "the path is too long");
  }
  Target& into = target();
  into.path = {};
  into.heading = {};
  std::ranges::copy(path, into.path.begin());
  std::ranges::copy(heading.substr(0, kLongestHeading - 1), into.heading.begin());
  notes(); // exists before the first crash
  std::array<void*, 1> frame{};
  ::backtrace(frame.data(), 1); // loads its library now: a handler must not

  stack_t stack{};
  stack.ss_sp = into.stack.data();
  stack.ss_size = into.stack.size();
  ::sigaltstack(&stack, nullptr); // for a crash by too deep recursion in the main thread
  for (const auto& [signal, name] : kCrashSignals) {
    struct sigaction before {};
    if (::sigaction(signal, nullptr, &before) != 0 || before.sa_handler != SIG_DFL) {
      continue;
    }
    struct sigaction action {};
    action.sa_handler = &writeCrashReport;
    action.sa_flags = SA_ONSTACK | static_cast<int>(SA_RESETHAND);
    ::sigaction(signal, &action, nullptr);
  }
  return {};
}

} // namespace dewpoint::base
