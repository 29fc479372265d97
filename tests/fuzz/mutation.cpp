// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/mutation.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace dewpoint::tests {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kMostInputBytes = 65'536;

constexpr std::array kNumbers{"0"sv,
                              "-1"sv,
                              "1"sv,
                              "nan"sv,
                              "inf"sv,
                              "-inf"sv,
                              "1e400"sv,
                              "-1e308"sv,
                              "1e-320"sv,
                              "1e30"sv,
                              "1000000"sv,
                              "4294967296"sv,
                              "1e12"sv,
                              "2147483648"sv,
                              "-2147483649"sv,
                              "1000000000"sv,
                              "0.5"sv,
                              "9223372036854775807"sv,
                              ".nan"sv,
                              "0x7F"sv,
                              "1_000"sv,
                              "1."sv,
                              "99999999999999999999"sv,
                              "1e"sv};

constexpr std::array kWords{"\n"sv,
                            "\r\n"sv,
                            "\0"sv,
                            "\xEF\xBB\xBF"sv,
                            "\xFF\xFE"sv,
                            "\xC3"sv,
                            "\xED\xA0\x80"sv,
                            "["sv,
                            "]"sv,
                            "[["sv,
                            "{"sv,
                            "}"sv,
                            "\""sv,
                            "'"sv,
                            "\"\"\""sv,
                            ","sv,
                            ":"sv,
                            "="sv,
                            "#"sv,
                            "&a "sv,
                            "*a"sv,
                            "- "sv,
                            "? "sv,
                            "---\n"sv,
                            "<a>"sv,
                            "</a>"sv,
                            "${HOME}"sv,
                            "a.a.a.a"sv,
                            "true"sv,
                            " "sv,
                            "\t"sv,
                            "\\u0000"sv,
                            "!!opencv-matrix"sv,
                            "<!--"sv,
                            "%"sv};

} // namespace

Mutation::Mutation(const std::vector<std::string>& corpus, std::uint64_t seed)
    : corpus_(corpus), random_(seed) {}

std::string Mutation::next() {
  std::string text = corpus_[below(corpus_.size())];
  for (std::size_t changes = 1 + below(4); changes > 0; --changes) {
    changeOnce(text);
  }
  text.resize(std::min(text.size(), kMostInputBytes));
  return text;
}

void Mutation::changeOnce(std::string& text) {
  const std::size_t at = below(text.size() + 1);
  switch (below(8)) {
  case 0:
    if (at < text.size()) {
      text[at] = static_cast<char>(random_());
    }
    break;
  case 1:
    if (at < text.size()) {
      text[at] = static_cast<char>(static_cast<unsigned char>(text[at]) ^ (1U << below(8)));
    }
    break;
  case 2:
    text.erase(at, 1 + below(1 + text.size() / 8));
    break;
  case 3:
    text.resize(at); // as a killed program leaves it
    break;
  case 4:
    text.insert(at, kWords[below(kWords.size())]);
    break;
  case 5:
    insertPart(text);
    break;
  default: // most fields are numbers
    replaceNumber(text);
    break;
  }
}

void Mutation::replaceNumber(std::string& text) {
  const auto isDigit = [](char letter) {
    return std::isdigit(static_cast<unsigned char>(letter)) != 0;
  };
  std::size_t begin = below(text.size() + 1);
  while (begin < text.size() && !isDigit(text[begin])) {
    ++begin;
  }
  std::size_t end = begin;
  while (end < text.size() && (isDigit(text[end]) || text[end] == '.')) {
    ++end;
  }
  text.replace(begin, end - begin, kNumbers[below(kNumbers.size())]);
}

void Mutation::insertPart(std::string& text) {
  const std::string& other = corpus_[below(corpus_.size())];
  const std::string part = other.substr(below(other.size() + 1), 1 + below(256));
  const std::size_t at = below(text.size() + 1);
  const std::size_t times = below(16) == 0 ? 100 : 1;
  for (std::size_t k = 0; k < times && text.size() < kMostInputBytes; ++k) {
    text.insert(at, part);
  }
}

} // namespace dewpoint::tests
