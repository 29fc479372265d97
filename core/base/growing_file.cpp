// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/growing_file.h"

#include <cerrno>
#include <cstring>

namespace dewpoint::base {

Result<GrowingFile> GrowingFile::create(const std::filesystem::path& path) {
  std::FILE* file = std::fopen(path.c_str(), "wbe");
  if (file == nullptr) {
    return failure(ErrorCode::FileUnwritable, path.string(), "", std::strerror(errno));
  }
  return GrowingFile(path.string(), file);
}

Status GrowingFile::append(std::string_view text) {
  if (!file_) {
    return failure(ErrorCode::FileUnwritable, name_, "", "it is already closed");
  }
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() ||
      std::fflush(file_.get()) != 0) {
    return writeError(errno);
  }
  return {};
}

Status GrowingFile::close() {
  if (!file_) {
    return failure(ErrorCode::FileUnwritable, name_, "", "it is already closed");
  }
  // Some file systems report a full disk only here.
  if (std::fclose(file_.release()) != 0) {
    return writeError(errno);
  }
  return {};
}

tl::unexpected<Error> GrowingFile::writeError(int reason) const {
  return failure(ErrorCode::FileUnwritable, name_, "", std::strerror(reason));
}

} // namespace dewpoint::base
