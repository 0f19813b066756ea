#include "source_texts.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace drape::locale {
namespace {

/// A string literal, or the other text between two of them.
struct Piece {
  bool isLiteral = false;
  std::string text;
};

void addUtf8(std::string& text, unsigned long letter) {
  if (letter < 0x80U) {
    text += static_cast<char>(letter);
  } else if (letter < 0x800U) {
    text += static_cast<char>(0xC0U | (letter >> 6U));
    text += static_cast<char>(0x80U | (letter & 0x3FU));
  } else {
    text += static_cast<char>(0xE0U | (letter >> 12U));
    text += static_cast<char>(0x80U | ((letter >> 6U) & 0x3FU));
    text += static_cast<char>(0x80U | (letter & 0x3FU));
  }
}

/// Reads the literal that begins behind the quote at `at`; moves `at` behind its end.
std::string readLiteral(std::string_view source, std::size_t& at) {
  std::string text;
  while (at < source.size() && source[at] != '"') {
    if (source[at] != '\\') {
      text += source[at++];
    } else if (source[at + 1] == 'u') {
      addUtf8(text, std::strtoul(std::string(source.substr(at + 2, 4)).c_str(), nullptr, 16));
      at += 6;
    } else {
      text += source[at + 1] == 'n' ? '\n' : source[at + 1];
      at += 2;
    }
  }
  ++at;
  return text;
}

/// The end of a comment or a character literal that begins at `at`; `at` itself if there is none.
std::size_t skipped(std::string_view source, std::size_t at) {
  const std::string_view rest = source.substr(at);
  if (rest.starts_with("//")) {
    return std::min(source.size(), source.find('\n', at));
  }
  if (rest.starts_with("/*")) {
    return source.find("*/", at) + 2;
  }
  const bool isSeparator = at > 0 && std::isalnum(static_cast<unsigned char>(source[at - 1])) != 0;  // 1'000
  if (rest.starts_with('\'') && !isSeparator) {
    const std::size_t first = rest.starts_with("'\\") ? 3 : 2;
    return source.find('\'', at + first) + 1;
  }
  return at;
}

std::vector<Piece> piecesOf(std::string_view source) {
  std::vector<Piece> pieces;
  std::string between;
  for (std::size_t at = 0; at < source.size();) {
    if (const std::size_t end = skipped(source, at); end != at) {
      at = end;
    } else if (source[at] != '"') {
      between += source[at++];
    } else {
      ++at;
      const std::string text = readLiteral(source, at);
      if (!pieces.empty() && between.find_first_not_of(" \n\t") == std::string::npos) {
        pieces.back().text += text;
      } else {
        pieces.push_back({false, between});
        pieces.push_back({true, text});
      }
      between.clear();
    }
  }
  pieces.push_back({false, between});
  return pieces;
}

bool isNameLetter(char each) {
  return std::isalnum(static_cast<unsigned char>(each)) != 0 || each == '_';
}

/// Takes the last word of a name and the blanks behind it from a text.
std::string_view takeWord(std::string_view& text) {
  while (!text.empty() && text.back() == ' ') {
    text.remove_suffix(1);
  }
  const std::string_view all = text;
  while (!text.empty() && isNameLetter(text.back())) {
    text.remove_suffix(1);
  }
  return all.substr(text.size());
}

/// Whether a call that translates its first argument opens at the end of this text: `texts(`, `Sentence(`,
/// `Sentence words(`, `showNotice(`.
bool endsWithCall(std::string_view text) {
  if (!text.ends_with('(') && !text.ends_with('{')) {
    return false;
  }
  text.remove_suffix(1);
  const std::string_view last = takeWord(text);
  if (text.ends_with("reader.")) {
    return false;  // of a scene file
  }
  const bool isBlank = text.ends_with(' ');
  const std::string_view before = isBlank ? takeWord(text) : std::string_view();
  return last == "texts" || last == "showNotice" || last == "Sentence" || before == "Sentence";
}

}  // namespace

SourceTexts textsOf(std::string_view source) {
  SourceTexts texts;
  std::string before;
  int depth = 0;  // of brackets within a first argument; 0: outside of one
  for (const Piece& piece : piecesOf(source)) {
    if (piece.isLiteral) {
      texts.all.push_back(piece.text);
      if (depth > 0) {
        texts.translated.push_back(piece.text);
      }
      before += '"';
      continue;
    }
    for (const char each : piece.text) {
      before += each;
      const bool opens = each == '(' || each == '{' || each == '[';
      const bool closes = each == ')' || each == '}' || each == ']';
      if (endsWithCall(before)) {
        depth = 1;  // an inner call counts from here
      } else if (depth > 0 && (closes || (each == ',' && depth == 1))) {
        depth -= 1;
      } else if (depth > 0 && opens) {
        ++depth;
      }
    }
  }
  return texts;
}

SourceTexts textsBelow(const std::filesystem::path& folder) {
  SourceTexts all;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string ending = entry.path().extension().string();
    if (ending != ".cpp" && ending != ".hpp") {
      continue;
    }
    std::ifstream file(entry.path());
    std::ostringstream source;
    source << file.rdbuf();
    const SourceTexts texts = textsOf(source.str());
    all.all.insert(all.all.end(), texts.all.begin(), texts.all.end());
    all.translated.insert(all.translated.end(), texts.translated.begin(), texts.translated.end());
  }
  return all;
}

}  // namespace drape::locale
