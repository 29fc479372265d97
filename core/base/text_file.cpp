// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>
#include <unistd.h>

namespace dewpoint::base {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

bool writeAndSync(const std::filesystem::path& file, const std::string& text) {
  const std::unique_ptr<std::FILE, CloseFile> stream(std::fopen(file.c_str(), "wb"));
  return stream && std::fwrite(text.data(), 1, text.size(), stream.get()) == text.size() &&
         std::fflush(stream.get()) == 0 && fsync(fileno(stream.get())) == 0;
}

} // namespace

Result<std::string> readTextFile(const std::filesystem::path& file) {
  std::error_code problem;
  if (!std::filesystem::exists(file, problem)) {
    return failure(ErrorCode::FileMissing, file.string(), "", "");
  }
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream || std::filesystem::is_directory(file, problem)) {
    return failure(ErrorCode::FileUnreadable, file.string(), "",
                   std::filesystem::is_directory(file, problem) ? "it is a folder" : "");
  }
  return text.str();
}

Status writeFlushed(const std::filesystem::path& file, const std::string& text) {
  errno = 0;
  return writeAndSync(file, text)
             ? Status()
             : Status(failure(ErrorCode::FileUnwritable, file.string(), "", std::strerror(errno)));
}

Status writeTextFile(const std::filesystem::path& file, const std::string& text) {
  auto beside = file;
  beside += ".part";
  if (auto written = writeFlushed(beside, text); !written) {
    std::error_code ignored;
    std::filesystem::remove(beside, ignored);
    written.error().file = file.string();
    return written;
  }
  std::error_code problem;
  std::filesystem::rename(beside, file, problem);
  if (problem) {
    return failure(ErrorCode::FileUnwritable, file.string(), "", problem.message());
  }
  return {};
}

} // namespace dewpoint::base
