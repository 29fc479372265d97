// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text_file.h"

#include "core/base/limits.h"
#include "core/base/table_text.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>
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

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Why nothing is read from what is no file; empty: it may be.
std::string whyNoText(std::filesystem::file_type kind) {
  switch (kind) {
  case std::filesystem::file_type::directory:
    return "it is a folder";
  case std::filesystem::file_type::character:
  case std::filesystem::file_type::block:
    return "it is a device"; // which may never end
  default:
    return "";
  }
}

Result<std::string> readUpTo(std::uintmax_t most, const std::filesystem::path& file) {
  std::error_code problem;
  const auto kind = std::filesystem::status(file, problem).type();
  if (kind == std::filesystem::file_type::not_found) {
    return failure(ErrorCode::FileMissing, file.string(), "", "");
  }
  if (const std::string reason = whyNoText(kind); !reason.empty()) {
    return failure(ErrorCode::FileUnreadable, file.string(), "", reason);
  }
  const auto tooLarge = [&] {
    return failure(ErrorCode::FileUnreadable, file.string(), "",
                   fmt::format("it is larger than {} MiB", most >> 20U));
  };
  if (kind == std::filesystem::file_type::regular &&
      std::filesystem::file_size(file, problem) > most && !problem) {
    return tooLarge();
  }
  const std::unique_ptr<std::FILE, CloseFile> stream(std::fopen(file.c_str(), "rb"));
  if (!stream) {
    return failure(ErrorCode::FileUnreadable, file.string(), "", "");
  }
  std::string text;
  std::array<char, std::size_t{1} << 16U> piece{};
  for (std::size_t count = piece.size(); count == piece.size();) {
    count = std::fread(piece.data(), 1, piece.size(), stream.get());
    text.append(piece.data(), count);
    if (text.size() > most) { // a pipe states no size
      return tooLarge();
    }
  }
  if (std::ferror(stream.get()) != 0) {
    return failure(ErrorCode::FileUnreadable, file.string(), "", "");
  }
  if (text.starts_with(kByteOrderMark)) {
    text.erase(0, kByteOrderMark.size());
  }
  return text;
}

} // namespace

Result<std::string> readTextFile(const std::filesystem::path& file) {
  return readUpTo(limits::kMaxTextBytes, file);
}

Result<std::string> readTableText(const std::filesystem::path& file) {
  return readUpTo(limits::kMaxTableBytes, file);
}

Status writeAndFlush(const std::filesystem::path& file, const std::string& text) {
  errno = 0;
  return writeAndSync(file, text)
             ? Status()
             : Status(failure(ErrorCode::FileUnwritable, file.string(), "", std::strerror(errno)));
}

Status writeTextFile(const std::filesystem::path& file, const std::string& text) {
  auto beside = file;
  beside += ".part";
  if (auto written = writeAndFlush(beside, text); !written) {
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
