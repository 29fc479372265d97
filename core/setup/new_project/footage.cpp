// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/new_project/footage.h"

#include "core/base/lower_case.h"
#include "core/capture/devices/device_access.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <compare>
#include <fstream>
#include <string_view>
#include <system_error>

namespace dewpoint::setup {
namespace {

namespace fs = std::filesystem;

// Endings of the types video/* and image/* of the desktops' shared database, and of raw streams
// that it does not know.
constexpr auto kVideoEndings = std::to_array<std::string_view>(
    {"264",  "265",  "3g2",  "3gp",  "3gp2", "3gpp", "3gpp2", "asf", "avf",  "avi",  "bdm",
     "bdmv", "clpi", "divx", "dv",   "f4v",  "fli",  "flc",   "flv", "fxm",  "h264", "h265",
     "hevc", "ivf",  "lrv",  "m1u",  "m2t",  "m2ts", "m4u",   "m4v", "mjp2", "mj2",  "mjpeg",
     "mjpg", "mk3d", "mkv",  "mng",  "moov", "mov",  "mp4",   "mpe", "mpeg", "mpg",  "mpl",
     "mpls", "mts",  "mxf",  "mxu",  "nsv",  "ogm",  "ogv",   "qt",  "qtvr", "rv",   "rvx",
     "ts",   "vdr",  "viv",  "vivo", "vob",  "webm", "wm",    "wmp", "wmv",  "y4m"});
constexpr auto kImageEndings = std::to_array<std::string_view>(
    {"avif", "bmp", "cr2", "cr3",  "crw", "dib", "dng",  "exr",  "gif",  "hdr", "heic",
     "heif", "ico", "j2k", "jfif", "jp2", "jpe", "jpeg", "jpf",  "jpg",  "jpx", "jxl",
     "nef",  "orf", "pam", "pbm",  "pcx", "pgm", "png",  "pnm",  "ppm",  "psd", "qoi",
     "raf",  "ras", "rw2", "sgi",  "svg", "tga", "tif",  "tiff", "webp", "xbm", "xpm"});

template <std::size_t Count>
bool holds(const std::array<std::string_view, Count>& endings, const fs::path& file) {
  const std::string ending = toLowerCase(file.extension().string());
  return ending.size() > 1 &&
         std::ranges::find(endings, std::string_view(ending).substr(1)) != endings.end();
}

/// For files whose ending says nothing.
bool hasFootageSignature(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::array<char, 16> bytes{};
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  const std::string_view head(bytes.data(), static_cast<std::size_t>(stream.gcount()));
  const auto at = [&](std::size_t offset, std::string_view magic) {
    return head.size() >= offset + magic.size() && head.substr(offset, magic.size()) == magic;
  };
  using namespace std::string_view_literals;
  return at(0, "\x1A\x45\xDF\xA3"sv)                                   // Matroska, WebM
         || (at(0, "RIFF") && (at(8, "AVI ") || at(8, "WEBP")))        //
         || at(4, "ftyp") || at(4, "moov") || at(4, "mdat")            // MP4, QuickTime
         || at(0, "\x00\x00\x01\xBA"sv) || at(0, "\x00\x00\x01\xB3"sv) // MPEG
         || at(0, "FLV\x01") || at(0, "YUV4MPEG2") || at(0, "DKIF")    //
         || at(0, "\x30\x26\xB2\x75\x8E\x66\xCF\x11"sv)                // ASF, WMV
         || at(0, "\x89PNG\r\n\x1A\n"sv) || at(0, "\xFF\xD8\xFF"sv)    // PNG, JPEG
         || at(0, "GIF87a") || at(0, "GIF89a") || at(0, "II*\0"sv)     // GIF, TIFF
         || at(0, "MM\0*"sv) || at(0, "\x76\x2F\x31\x01"sv);           // TIFF, OpenEXR
}

/// One character as it is sorted: what it is first, then its letter without case and accent.
struct SortKey {
  int kind = 0; ///< 0 end, 1 anything else, 2 digit, 3 letter
  int letter = 0;
  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the 0 of a comparison for a pointer.
  auto operator<=>(const SortKey&) const = default;
};

/// Base letters of U+00C0 to U+00FF; '*' is no letter.
constexpr std::string_view kLatin =
    "aaaaaaaceeeeiiiidnooooo*ouuuuytsaaaaaaaceeeeiiiidnooooo*ouuuuyty";

SortKey sortKeyAt(std::string_view text, std::size_t& offset) {
  if (offset >= text.size()) {
    return {};
  }
  const auto byte = static_cast<unsigned char>(text[offset++]);
  if (byte == 0xC3 && offset < text.size()) {
    const auto next = static_cast<unsigned char>(text[offset]);
    const char base = next >= 0x80 && next < 0xC0 ? kLatin[next - 0x80U] : '*';
    if (base != '*') {
      ++offset;
      return {3, base};
    }
  }
  if (std::isalpha(byte) != 0) {
    return {3, std::tolower(byte)};
  }
  return {std::isdigit(byte) != 0 ? 2 : byte >= 0x80 ? 3 : 1, byte};
}

/// The digits from `offset` on, without leading zeros.
std::string_view numberAt(std::string_view text, std::size_t& offset) {
  const auto isDigit = [&](std::size_t k) {
    return k < text.size() && std::isdigit(static_cast<unsigned char>(text[k])) != 0;
  };
  while (isDigit(offset + 1) && text[offset] == '0') {
    ++offset;
  }
  const std::size_t first = offset;
  while (isDigit(offset)) {
    ++offset;
  }
  return text.substr(first, offset - first);
}

std::strong_ordering inOrder(std::string_view one, std::string_view other) {
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < one.size() || j < other.size()) {
    std::size_t nextI = i;
    std::size_t nextJ = j;
    const SortKey left = sortKeyAt(one, nextI);
    const SortKey right = sortKeyAt(other, nextJ);
    if (left.kind == 2 && right.kind == 2) {
      const auto first = numberAt(one, i);
      const auto second = numberAt(other, j);
      const auto longer = first.size() <=> second.size();
      if (const auto order = std::is_neq(longer) ? longer : first <=> second; std::is_neq(order)) {
        return order;
      }
      continue;
    }
    if (left != right) {
      return left <=> right;
    }
    i = nextI;
    j = nextJ;
  }
  return std::strong_ordering::equal;
}

bool isDevice(const std::string& location) {
  return location.starts_with("/dev/");
}

/// A folder with an image in it.
bool holdsImages(const fs::path& folder) {
  std::error_code problem;
  std::error_code unread; // the rest of a disk that gives up
  for (fs::directory_iterator entry(folder, unread); !unread && entry != fs::directory_iterator();
       entry.increment(unread)) {
    if (entry->is_regular_file(problem) && holds(kImageEndings, entry->path())) {
      return true;
    }
  }
  return false;
}

} // namespace

bool isBeforeInDisplayOrder(const std::string& name, const std::string& other) {
  const auto order = inOrder(name, other);
  return std::is_neq(order) ? std::is_lt(order) : name < other;
}

std::vector<std::string> sortedInNaturalOrder(std::vector<std::string> files) {
  std::ranges::stable_sort(files, [](const std::string& one, const std::string& other) {
    return isBeforeInDisplayOrder(fs::path(one).filename().string(),
                                  fs::path(other).filename().string());
  });
  return files;
}

bool isFootage(const fs::path& file) {
  return holds(kVideoEndings, file) || holds(kImageEndings, file) || hasFootageSignature(file);
}

bool canBeImageSource(const std::string& location) {
  std::error_code problem;
  if (fs::is_directory(location, problem)) {
    return holdsImages(location);
  }
  return !fs::exists(location, problem) || isDevice(location) || isFootage(location);
}

std::vector<std::string> footageIn(const fs::path& folder) {
  std::vector<std::string> found;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(folder, problem)) {
    const bool folderOfImages = entry.is_directory(problem) && holdsImages(entry.path());
    const bool video = entry.is_regular_file(problem) && isFootage(entry.path()) &&
                       !holds(kImageEndings, entry.path());
    if (folderOfImages || video) {
      found.push_back(entry.path().string());
    }
  }
  return sortedInNaturalOrder(std::move(found));
}

std::vector<std::string> connectedCameras() {
  std::vector<std::string> paths;
  for (const CameraDevice& device : systemDevices()->listDevices()) {
    paths.push_back(device.path);
  }
  return paths;
}

} // namespace dewpoint::setup
