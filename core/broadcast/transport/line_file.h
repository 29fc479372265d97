// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/broadcast/transport/file_descriptor.h"
#include "core/broadcast/transport/outlet.h"

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>

namespace dewpoint::broadcast {

/// Writes lines to a file, a named pipe or standard output. send() opens a named pipe as soon as a
/// program reads from it. Each reader first gets the preamble, the text before the first frame. A
/// line that does not fit into a pipe is dropped completely. send() blocks SIGPIPE in the thread
/// that calls it.
class LineFile final : public PreambleOutlet {
public:
  /// Opens an output. If `file` is "-", this is standard output. A file that does not exist is
  /// created, and the contents of an existing file are replaced. Error: FileUnwritable.
  static Result<std::unique_ptr<LineFile>> open(const std::filesystem::path& file);

  void setPreamble(const std::string& preamble) override;
  void send(const std::vector<std::string>& pieces) override;
  OutletReport report() const override;

private:
  explicit LineFile(std::filesystem::path file) : file_(std::move(file)) {}
  bool isReady();
  void write(const std::string& piece);
  /// Stores the reason why nothing can be written now.
  void fail(int reason);

  std::filesystem::path file_;
  FileDescriptor own_;    ///< not standard output, which stays open
  int number_ = -1;       ///< -1: no program reads the pipe
  bool isPipe_ = false;   ///< writing could wait
  bool isNamed_ = false;  ///< a named pipe, which can be opened again
  bool isBroken_ = false; ///< nothing more can be written
  std::string preamble_;
  bool isOpened_ = false;    ///< the present reader has got the preamble
  mutable std::mutex mutex_; ///< of the report
  OutletReport report_;
};

} // namespace dewpoint::broadcast
